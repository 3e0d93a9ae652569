//! Lab cases.

use saute_lab::{Case, CookCase, MOST_WORK, run, work};

use crate::kitchen_files::LIBRARY;
use crate::text;

/// Cases with more work are read, checked and judged only [node steps], so that many inputs are tried.
const MOST_RUN: f64 = 1e5;

/// A case of the lab or a cook case; one of little work runs.
pub fn lab(bytes: &[u8]) {
    let Some(text) = text(bytes) else { return };
    if CookCase::is_one(text) {
        let _ = CookCase::parse(text, "case.toml", &LIBRARY);
        return;
    }
    let Ok(case) = Case::parse(text, "case.toml", &LIBRARY) else { return };
    let work = work(&case);
    // A work that is not finite is refused by the command, as one above its limit.
    if work <= MOST_RUN.min(MOST_WORK) {
        let report = run(&case, || 0.0);
        serde_json::to_string(&report).expect("a report can be written");
    }
}

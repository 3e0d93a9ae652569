//! Colours that a case expects, measured on flat pictures of the end of its cook.

use std::sync::Arc;

use saute_app::headless::Gpu;
use saute_app::seen_colour::seen_colour;
use saute_app::shot::ShotError;
use saute_kitchen::Library;
use saute_kitchen::cook_case::{CookCase, Seen};
use saute_kitchen::food::Scale;
use saute_kitchen::lab::Verdict;

use crate::error::CliError;

/// Compares all colours of a case.
pub fn verdicts(case: &CookCase, library: &Library, scale: &Arc<Scale>) -> Result<Vec<Verdict>, CliError> {
    if case.seen().is_empty() {
        return Ok(Vec::new());
    }
    let cook = case.cook(library)?;
    let gpu = Gpu::open().map_err(ShotError::from)?;
    let Some(piece) = cook.kitchen.pieces().first() else { return Ok(Vec::new()) };
    let verdict = |seen: &Seen| {
        let shown = seen_colour(&gpu, &cook.kitchen, piece, seen.place, scale);
        case.verdict_on_colour(seen, shown)
    };
    Ok(case.seen().iter().map(verdict).collect())
}

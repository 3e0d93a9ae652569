//! The shipped recipes, each cooked once for all tests.

use std::collections::BTreeMap;
use std::sync::OnceLock;

use serde_json::Value;

use crate::running::{Ran, names_in, run};

/// Ids of the shipped recipes with one steak.
pub const SHIPPED: [&str; 4] = ["flip-every-30-s", "medium", "rare", "well-done"];

/// Ids of the shipped recipes with many foods or another pan.
pub const DISHES: [&str; 4] = ["fried-potatoes", "grill-pan-steak", "shrimp", "steak-carrots-leeks"];

/// Ids of the shipped recipes with another food.
pub const PANTRY: [&str; 10] = [
    "cod-in-butter",
    "crisp-bacon",
    "crisp-tofu",
    "fried-chicken-breast",
    "fried-mushrooms",
    "fried-peppers",
    "fried-pork-chop",
    "fried-salmon",
    "golden-onions",
    "sunny-side-up",
];

/// Output and files of a cook with `--json --out`.
#[derive(Debug)]
pub struct Cooked {
    pub ran: Ran,
    pub summary: Value,
    pub files: BTreeMap<String, Vec<u8>>,
}

/// Returns a shipped recipe, cooked.
pub fn cooked(id: &str) -> &'static Cooked {
    static COOKED: [OnceLock<Cooked>; 4] = [const { OnceLock::new() }; 4];
    let place = SHIPPED.iter().position(|s| *s == id).expect("a shipped recipe");
    COOKED[place].get_or_init(|| cook(id))
}

/// Cooks the recipe with a path or an id.
pub fn cook(recipe: &str) -> Cooked {
    let dir = tempfile::tempdir().unwrap();
    let out = dir.path().join("out");
    let ran = run(&["cook", recipe, "--json", "--out", out.to_str().unwrap()]);
    let read = |name: String| (name.clone(), std::fs::read(out.join(name)).unwrap());
    let summary = serde_json::from_str(&ran.out).unwrap_or_else(|e| panic!("{recipe}: {e}\n{}", ran.err));
    Cooked { summary, files: names_in(&out).into_iter().map(read).collect(), ran }
}

impl Cooked {
    /// Returns a number of the summary, as in `/pan_c/peak`.
    pub fn number(&self, pointer: &str) -> f64 {
        self.summary.pointer(pointer).and_then(Value::as_f64).unwrap_or_else(|| panic!("no number at {pointer}"))
    }

    /// Returns the time of the first step with an action [s].
    pub fn time_of(&self, action: &str) -> f64 {
        let steps = self.summary["steps"].as_array().unwrap();
        steps.iter().find(|s| s["action"] == action).unwrap()["time_s"].as_f64().unwrap()
    }

    /// Returns a text file.
    pub fn text(&self, name: &str) -> &str {
        std::str::from_utf8(&self.files[name]).unwrap()
    }
}

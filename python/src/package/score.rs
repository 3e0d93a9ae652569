//! How well a kitchen meets a goal: the score of `saute plan`.

use std::collections::BTreeMap;

use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use saute_kitchen::{Kitchen, Library};
use saute_plan::goal::{Goal, Outcome, Score, Wish};

use crate::package::expected::ranged;
use crate::package::kitchen::PyKitchen;

/// Reads a goal: a class of a scale, or "core=54" [°C], with a crust [%].
pub(crate) fn goal(wish: &str, crust_pct: f64, scale: &str, library: &Library) -> PyResult<Goal> {
    ranged(crust_pct, "crust_pct", [0.0, 100.0])?;
    let unknown =
        || PyValueError::new_err(format!("there is no scale \"{scale}\"; there are: {}", library.scale_names()));
    let scale = library.scale(scale).ok_or_else(unknown)?;
    let wish: Wish =
        wish.parse().map_err(|error: saute_plan::goal::TargetError| PyValueError::new_err(error.to_string()))?;
    Goal::new(&wish, scale, crust_pct).map_err(|error| PyValueError::new_err(error.to_string()))
}

/// Reads the outcome of a kitchen, and its score after so many flips [points].
pub(crate) fn scored(kitchen: &Kitchen, goal: &Goal, flips: usize) -> (Outcome, f64) {
    let masses: Vec<f64> = kitchen.pieces().iter().map(|piece| piece.model.raw_mass()).collect();
    let outcome = Outcome::read(kitchen, &masses, goal);
    (outcome, Score::of(&outcome, flips, goal).0)
}

#[pymethods]
impl PyKitchen {
    /// The score of the present state against a goal, "medium" or "core=54", after so many flips [points], and its terms.
    #[pyo3(signature = (target = "medium", *, crust_pct = 60.0, scale = "chefs", flips = 0))]
    fn score(&self, target: &str, crust_pct: f64, scale: &str, flips: usize) -> PyResult<BTreeMap<&'static str, f64>> {
        if self.state.pieces().is_empty() {
            return Err(PyValueError::new_err("there is no food in the kitchen to score"));
        }
        let (outcome, score) = scored(&self.state, &goal(target, crust_pct, scale, &self.shelf.library)?, flips);
        Ok(BTreeMap::from([
            ("score", score),
            ("core_peak_c", outcome.core_peak_c),
            ("at_core", outcome.at_core),
            ("target_share_pct", outcome.target_share_pct),
            ("beyond_pct", outcome.beyond_pct),
            ("crust_pct", outcome.crust_pct),
            ("least_crust_pct", outcome.least_crust_pct),
            ("charred_pct", outcome.charred_pct),
            ("lost_pct", outcome.lost_pct),
            ("hottest_c", outcome.hottest_c),
            ("fire_hazard", f64::from(u8::from(outcome.fire_hazard))),
        ]))
    }
}

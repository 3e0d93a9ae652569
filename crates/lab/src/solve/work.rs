//! The work of a case, estimated before it runs.

use saute_heat::conduction::super_step::SuperStep;
use saute_kitchen::TICK_S;

use crate::case::{Case, Physics};
use crate::solve::body::node_count;
use crate::solve::solver::Solver;

/// Largest work of a case [node steps] (chosen: about a day on one core).
pub const MOST_WORK: f64 = 3e12;

/// Returns the number of node updates that a case takes [node steps].
///
/// Conduction: nodes × steps of the longest stable length × stages; properties that vary change it by a small factor.
/// Cooking: nodes × ticks, without the sub-steps of thin layers.
pub fn work(case: &Case) -> f64 {
    let own = match case.physics {
        Physics::Cooking => node_count(case.shape, &case.bodies) * case.duration / (TICK_S * case.step_factor),
        Physics::Conduction => {
            let solver = Solver::new(case);
            let [step, explicit] = solver.longest_step(case);
            let stages = SuperStep::stages_for(step, explicit) as f64;
            solver.temperature.len() as f64 * stages * case.duration / step
        }
    };
    own + case.compare.as_ref().map_or(0.0, |other| work(other))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use saute_kitchen::Library;

    use super::*;
    use crate::case::validation_cases;

    #[test]
    fn every_shipped_case_is_far_below_the_largest_work() {
        let library = Library::embedded().unwrap();
        let cases = validation_cases();
        let largest = cases.values().filter_map(|text| Case::parse(text, "case", &library).ok()).map(|c| work(&c));
        let largest = largest.fold(0.0, f64::max);
        assert!(largest > 1e6 && largest < 0.1 * MOST_WORK, "{largest:e}");
    }

    #[test]
    fn the_work_of_fine_layers_of_a_good_conductor_is_known_before_it_is_done() {
        let library = Library::embedded().unwrap();
        let text = "duration_s = 1e7\n[body]\nshape = \"slab\"\nsize_mm = [0.1]\nresolution_mm = 1e-3\ninitial_c = 5\n\
            [material]\nconductivity_w_mk = 1e4\ndensity_kg_m3 = 1e-2\nspecific_heat_j_kgk = 1\n\
            [[boundary]]\nface = \"bottom\"\nh_w_m2k = 10\nambient_c = 100\n";
        let case = Case::parse(text, "case", &library).unwrap();
        assert!(work(&case) > 1e6 * MOST_WORK, "{:e}", work(&case));
    }
}

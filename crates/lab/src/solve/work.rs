//! The work of a case, estimated before it runs.

use saute_food::{FoodSolver, FoodState};
use saute_heat::conduction::super_step::SuperStep;
use saute_kitchen::TICK_S;

use crate::case::{Case, CookingCase, Physics};
use crate::solve::body::node_count;
use crate::solve::cooking_body::FoodBody;
use crate::solve::solver::Solver;

/// Largest work of a case [node steps] (chosen: about a day on one core).
pub const MOST_WORK: f64 = 3e12;

/// Returns the number of node updates that a case takes [node steps].
///
/// Conduction: nodes × steps of the longest stable length × stages. Cooking: nodes × ticks × sub-steps of the thinnest
/// layer, raw. Properties that vary change either by a small factor.
pub fn work(case: &Case) -> f64 {
    let own = match (case.physics, &case.cooking) {
        (Physics::Cooking, Some(cooking)) => cooking_work(case, cooking),
        _ => {
            let solver = Solver::new(case);
            let [step, explicit] = solver.longest_step(case);
            let stages = SuperStep::stages_for(step, explicit) as f64;
            solver.temperature.len() as f64 * stages * case.duration / step
        }
    };
    own + case.compare.as_ref().map_or(0.0, |other| work(other))
}

/// Returns the work of a cooking case [node steps]; a body that cannot be built takes none.
fn cooking_work(case: &Case, cooking: &CookingCase) -> f64 {
    let dt = (TICK_S * case.step_factor).min(case.duration);
    let ticks = node_count(case.shape, &case.bodies) * case.duration / dt;
    // Without the sub-steps it is too much already: a body of so many nodes need not be built.
    if ticks > MOST_WORK {
        return ticks;
    }
    let Ok(body) = FoodBody::new(case, cooking) else { return 0.0 };
    let raw = FoodState::raw(&body.model, case.bodies[0].initial);
    ticks * f64::from(FoodSolver::steps_of_tick(&body.model, &raw, dt))
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
    #[test]
    fn the_sub_steps_of_thin_layers_of_food_are_work() {
        let library = Library::embedded().unwrap();
        let text = |resolution: &str, grading: &str| {
            format!(
                "duration_s = 1e5\n[body]\nshape = \"slab\"\nsize_mm = [10]\nresolution_mm = {resolution}\ngrading = {grading}\n\
                initial_c = 5\n[material]\nfood = \"beef-lean\"\n[solver]\nphysics = \"cooking\"\n\
                [[boundary]]\nface = \"all\"\nh_w_m2k = 500\nambient_c = 90\n"
            )
        };
        let of = |text: &str| work(&Case::parse(text, "case", &library).unwrap());
        let (coarse, thin) = (of(&text("1", "0")), of(&text("1e-3", "3")));
        // Ten thousand layers of a micrometre and less: each tick takes some hundred thousand steps.
        assert!(coarse < 1e8 && thin > MOST_WORK, "{coarse:e} {thin:e}");
    }
}

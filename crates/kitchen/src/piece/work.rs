//! The work of a piece, bounded before it is cooked.

use saute_food::{BuildError, FoodModel, FoodSolver, FoodState};

use crate::{TICK_S, kelvin};

/// Largest work of a tick [node steps] (chosen: up to 25 ms, a quarter of the time that the tick simulates).
const MOST_WORK: f64 = 5e5;
/// Temperature at which the steps are counted [°C] (chosen: as food comes from the refrigerator).
const RAW_C: f64 = 5.0;

/// Checks that a tick of a raw piece takes little work; drying and heating change it by a small factor, and ice requires up
/// to six times as many steps until it has thawed. A mesh finer than the default requires more: its nodes grow
/// with the cube and its steps with the square of the fineness.
///
/// # Errors
/// [`BuildError::Slow`] with the number of steps.
pub(crate) fn check(model: &FoodModel, coarseness: f64) -> Result<(), BuildError> {
    let steps = FoodSolver::steps_of_tick(model, &FoodState::raw(model, kelvin(RAW_C)), TICK_S);
    let nodes = model.mesh().node_count();
    let asked = libm::pow(coarseness.min(1.0), -5.0);
    if nodes as f64 * f64::from(steps) > asked * MOST_WORK { Err(BuildError::Slow { steps, nodes }) } else { Ok(()) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::data::library::Library;
    use crate::{Kitchen, MeshSize, PieceOrder};
    use saute_food::Rules;

    #[test]
    fn shipped_foods_of_every_size_are_built() {
        let library = Library::embedded().expect("embedded data");
        let mut kitchen = Kitchen::new(&library, "carbon-steel-26", kelvin(20.0)).expect("pan");
        let mut most = 0.0_f64;
        for (kind, food) in &library.foods {
            for mm in [&food.size.min_mm, &food.size.max_mm] {
                let size = food.form.extent(mm).expect("dimensions").map(|mm| 1e-3 * mm);
                let (id, temperature, mesh) = (kind.clone(), kelvin(5.0), MeshSize::Default);
                let order = PieceOrder {
                    id,
                    kind: kind.clone(),
                    size,
                    temperature,
                    seed: 1,
                    coarseness: 1.0,
                    rules: Rules::Full,
                    outline: crate::food::OutlineKind::Natural,
                    mesh,
                };
                kitchen.add(&library, &order).expect("builds");
                let model = &kitchen.pieces()[0].model;
                let steps = FoodSolver::steps_of_tick(model, &FoodState::raw(model, kelvin(5.0)), TICK_S);
                most = most.max(f64::from(steps) * model.mesh().node_count() as f64);
                kitchen.remove(kind);
            }
        }
        println!("at most {most:e} node steps");
        assert!(most < 0.5 * MOST_WORK, "{most:e}");
    }
}

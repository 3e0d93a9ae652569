//! Which part of a log is compared: from the put to the end of the cook, unless requested otherwise.

use saute_recipe::action::ActionKind;
use saute_recipe::{Recipe, Trigger};

use super::log::reading::Reading;
use super::observed::{Observed, Quantity};

/// The part of a log that is compared, and where it is in the cook.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Compared {
    /// Time in the recipe at which the log begins [s].
    pub shift_s: f64,
    /// Time in the recipe from which the core is compared [s]: before it, the probe is in the air or in the refrigerator.
    pub core_from_s: f64,
    /// Time in the recipe from which the pan is compared [s].
    pub pan_from_s: f64,
    /// Time in the recipe up to which both are compared [s]; what the log has after the recipe's end is left out in any case.
    pub to_s: f64,
}

impl Compared {
    /// Returns the part that a recipe's cook suggests: the pan from the beginning, the core from the put.
    pub fn of(recipe: &Recipe, shift_s: f64) -> Self {
        Self { shift_s, core_from_s: put_s(recipe), pan_from_s: 0.0, to_s: f64::INFINITY }
    }

    /// Returns what a core is at the put of a recipe's first food: time in the log [s] and temperature [K].
    pub fn begin(&self, recipe: &Recipe) -> Option<(f64, f64)> {
        Some((put_s(recipe) - self.shift_s, recipe.foods.first()?.temperature))
    }

    /// Returns the points of a curve in the time of the cook, those outside left out.
    pub fn points(&self, quantity: Quantity, points: &[(f64, f64)]) -> Vec<(f64, f64)> {
        let from_s = if quantity == Quantity::Pan { self.pan_from_s } else { self.core_from_s };
        let shifted = points.iter().map(|(at_s, kelvin)| (at_s + self.shift_s, *kelvin));
        shifted.filter(|(at_s, _)| (from_s..=self.to_s).contains(at_s)).collect()
    }

    /// Adds the curves of a log to what was observed.
    pub fn add(&self, reading: &Reading, observed: &mut Observed) {
        for (quantity, curve) in [(Quantity::Core, &reading.core), (Quantity::Pan, &reading.pan)] {
            if let Some(curve) = curve {
                observed.add_curve(quantity, &self.points(quantity, &curve.points));
            }
        }
    }
}

/// The time at which the first food is put into the pan [s]; 0 where none is, or where it waits for a condition.
fn put_s(recipe: &Recipe) -> f64 {
    let mut now = 0.0;
    for step in &recipe.steps {
        now = match step.trigger {
            Trigger::At(at_s) => at_s,
            Trigger::After(after_s) => now + after_s,
            Trigger::When(_) => return 0.0,
        };
        if step.action.kind() == ActionKind::Put {
            return now;
        }
    }
    0.0
}

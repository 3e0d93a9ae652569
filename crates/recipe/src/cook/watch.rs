//! Watches a condition from tick to tick.

use serde::{Deserialize, Serialize};

use crate::condition::{Condition, Side};
use saute_kitchen::kitchen::Kitchen;

/// Differences below this are rounding errors [K, kg] (chosen: area means of a uniform temperature are off by 1e-12).
const SAME_VALUE: f64 = 1e-7;

/// Memory of which foods have met a condition since it was first looked at.
#[derive(Clone, Debug, Default, Deserialize, Serialize)]
pub(crate) struct Watch {
    met: Vec<bool>,
}

impl Watch {
    /// Looks at a condition; returns true once every food has met it.
    pub(crate) fn look(&mut self, condition: &Condition, kitchen: &Kitchen) -> bool {
        self.update(condition.side, condition.value, &condition.values(kitchen))
    }

    fn update(&mut self, side: Side, value: f64, measured: &[f64]) -> bool {
        self.met.resize(measured.len(), false);
        for (met, measured) in self.met.iter_mut().zip(measured) {
            *met |= match side {
                Side::Above => measured - value > -SAME_VALUE,
                Side::Below => measured - value < SAME_VALUE,
            };
        }
        self.met.iter().all(|met| *met)
    }
}

/// Returns true if a bare temperature is exceeded by all foods, so that it means something else than in older versions,
/// where it waited for the fall.
pub(crate) fn is_passed(condition: &Condition, kitchen: &Kitchen) -> bool {
    let past = |measured: &f64| measured - condition.value >= SAME_VALUE;
    condition.plain && condition.side == Side::Above && condition.values(kitchen).iter().all(past)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns the result for each row of measured values against a value of 50.
    fn looks<const N: usize, const M: usize>(side: Side, rows: [[f64; M]; N]) -> [bool; N] {
        let mut watch = Watch::default();
        rows.map(|row| watch.update(side, 50.0, &row))
    }

    #[test]
    fn a_condition_that_holds_is_met_at_once_and_otherwise_when_it_comes_to_hold() {
        assert_eq!(looks(Side::Above, [[48.0], [49.0], [51.0]]), [false, false, true]);
        assert_eq!(looks(Side::Above, [[58.0]]), [true]);
        assert_eq!(looks(Side::Above, [[50.0 - 1e-9]]), [true]);
        assert_eq!(looks(Side::Below, [[58.0], [51.0], [49.5]]), [false, false, true]);
        assert_eq!(looks(Side::Below, [[48.0]]), [true]);
        assert_eq!(looks(Side::Above, [[f64::NAN]]), [false]);
    }

    #[test]
    fn of_several_foods_each_must_have_met_it_but_may_have_come_back() {
        assert_eq!(
            looks(Side::Above, [[48.0, 47.0], [51.0, 48.0], [49.0, 49.0], [49.0, 51.0]]),
            [false, false, false, true]
        );
        assert_eq!(looks(Side::Below, [[48.0, 53.0], [47.0, 51.0], [46.0, 49.5]]), [false, false, true]);
    }
}

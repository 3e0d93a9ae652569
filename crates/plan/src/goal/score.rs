//! How good a cook is: one number for comparing, and what is missing to the goal.
//!
//! score = share − 1 · missing crust − 1 · charred − 5 · miss of the core − 0.5 · |core − aim| − 0.1 · mass loss − 0.5 · heat above 295 °C
//! − 0.1 · flips
//!
//! | term | unit | meaning |
//! |---|---|---|
//! | share | % | of the section in the class of the goal |
//! | missing crust | points of % | how much less than wanted of the faces is browned, on the face with less of it |
//! | charred | % | of the faces |
//! | miss of the core | K (points of %: a fifth of the weight) | distance from the band that meets the goal |
//! | core − aim | the same | distance from the value that is aimed at |
//! | mass loss | % | |
//! | heat above 295 °C | K | of the hottest place of the pan; oils flash at 310–320 °C, and a hob may give 10 % more than it says |
//! | flips | number | work of the hand |
//!
//! A cook that passes the flash point of its oil scores 100 points less. The weights are chosen: the share counts first, a core
//! that misses its class by 2 K outweighs ten points of it, and juice and work decide between cooks that are otherwise equal.

use core::fmt;

use saute_kitchen::food::change::doneness::Measure;
use serde::{Deserialize, Serialize};

use crate::goal::{Goal, Outcome};

/// Weights of the formula, in points per unit (chosen, see above).
const CRUST: f64 = 1.0;
const CHARRED: f64 = 1.0;
const MISS: f64 = 5.0;
const OFF_AIM: f64 = 0.5;
const LOST: f64 = 0.1;
const HOT: f64 = 0.5;
const HOT_C: f64 = 295.0;
const FLIP: f64 = 0.1;
const FIRE: f64 = 100.0;
/// Points of a share that weigh as much as a kelvin [-] (chosen: 5 °C and 25 % are each half of a class).
const PCT_PER_K: f64 = 5.0;

/// Charred share of the faces from which a cook is burnt [%] (chosen: some black edges are part of a crust).
pub const BURNT_PCT: f64 = 5.0;

/// How good a cook is [points]; the highest possible value is 100.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, PartialOrd, Serialize)]
pub struct Score(pub f64);

/// What is missing to a goal.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Shortfall {
    /// The core stays below the class.
    Undercooked,
    /// The core passes the class.
    Overcooked,
    /// Too little of a face is browned.
    Crust,
    /// Too much of the faces is charred.
    Burnt,
    /// The oil passes its flash point.
    Fire,
}

impl Score {
    /// Scores an outcome of a cook with a number of flips against a goal.
    pub fn of(outcome: &Outcome, flips: usize, goal: &Goal) -> Self {
        let in_k = if goal.scale.measure() == Measure::Peak { 1.0 } else { 1.0 / PCT_PER_K };
        let missing = (goal.crust_pct - outcome.least_crust_pct).max(0.0);
        let off_aim = (outcome.at_core - goal.aim).abs();
        let penalties = CRUST * missing
            + CHARRED * outcome.charred_pct
            + in_k * (MISS * goal.miss(outcome.at_core) + OFF_AIM * off_aim)
            + LOST * outcome.lost_pct
            + HOT * (outcome.hottest_c - HOT_C).max(0.0)
            + FLIP * flips as f64
            + if outcome.fire_hazard { FIRE } else { 0.0 };
        Self(outcome.target_share_pct - penalties)
    }
}

impl Shortfall {
    /// Returns everything that is missing in an outcome; nothing if it meets the goal.
    pub fn of(outcome: &Outcome, goal: &Goal) -> Vec<Self> {
        let cases = [
            (Self::Undercooked, outcome.at_core < goal.core[0]),
            (Self::Overcooked, outcome.at_core > goal.core[1]),
            (Self::Crust, outcome.least_crust_pct < goal.crust_pct),
            (Self::Burnt, outcome.charred_pct > BURNT_PCT),
            (Self::Fire, outcome.fire_hazard),
        ];
        cases.into_iter().filter(|(_, is_missing)| *is_missing).map(|(shortfall, _)| shortfall).collect()
    }

    /// Returns the shortfall of an outcome in English.
    pub fn words(self, outcome: &Outcome, goal: &Goal) -> String {
        let (core, unit, [low, high]) = (outcome.at_core, goal.unit(), goal.core);
        match self {
            Self::Undercooked => format!("the core reaches {core:.1} {unit} of at least {low} {unit}"),
            Self::Overcooked => format!("the core reaches {core:.1} {unit} of at most {high} {unit}"),
            Self::Crust => {
                let (least, wanted) = (outcome.least_crust_pct, goal.crust_pct);
                format!("{least:.0} % of the paler face is browned of {wanted:.0} % wanted")
            }
            Self::Burnt => format!("{:.0} % of the faces is charred", outcome.charred_pct),
            Self::Fire => "the oil passes its flash point".to_owned(),
        }
    }
}

impl fmt::Display for Score {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{:.1}", self.0)
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use saute_kitchen::Library;

    use super::*;

    fn medium() -> Goal {
        Goal::new(&"medium".parse().unwrap(), Library::embedded().unwrap().scale("chefs").unwrap(), 60.0).unwrap()
    }

    fn on_target() -> Outcome {
        let (core_peak_c, at_core) = (61.5, 61.5);
        Outcome {
            core_peak_c,
            at_core,
            target_share_pct: 70.0,
            least_crust_pct: 90.0,
            lost_pct: 15.0,
            ..Outcome::default()
        }
    }

    #[test]
    fn the_score_is_the_formula_on_its_page() {
        let of = |outcome: Outcome| Score::of(&outcome, 5, &medium()).0;
        assert!((of(on_target()) - (70.0 - 1.5 - 0.5)).abs() < 1e-9);
        assert!((of(Outcome { at_core: 57.5, ..on_target() }) - (68.0 - 12.5 - 2.0)).abs() < 1e-9);
        assert!(
            (of(Outcome { least_crust_pct: 40.0, charred_pct: 3.0, ..on_target() }) - (68.0 - 20.0 - 3.0)).abs() < 1e-9
        );
        assert!((of(Outcome { fire_hazard: true, hottest_c: 311.0, ..on_target() }) + 32.0 + 8.0).abs() < 1e-9);
    }

    #[test]
    fn a_shortfall_is_named_and_a_cook_on_target_has_none() {
        assert_eq!(Shortfall::of(&on_target(), &medium()), []);
        let pale_and_rare = Outcome { at_core: 55.0, least_crust_pct: 10.0, ..on_target() };
        let missing = Shortfall::of(&pale_and_rare, &medium());
        assert_eq!(missing, [Shortfall::Undercooked, Shortfall::Crust]);
        assert!(missing[1].words(&pale_and_rare, &medium()).contains("10 % of the paler face"));
    }
}

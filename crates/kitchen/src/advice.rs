//! Advice on the next steps, from readings of the kitchen, and the reason why a hob that is on gives no power.
//!
//! A person who follows the first advice, each time that it is due, ends with the goal.

pub mod coaching;
mod no_power;
mod situation;

use saute_food::Scale;
use saute_food::change::doneness::Measure;

pub use self::no_power::NoPower;
pub use self::situation::{Situation, advise, usual_powers_w};

/// Mean temperature of the pan's floor from which food may go in [°C] (chosen: below it a wet face cooks in its own
/// juice before it browns).
pub const WARM_ENOUGH_C: f64 = 160.0;
/// Temperature at which the pan is called hot [°C] (chosen: a drop of water dances, oil does not smoke yet).
pub const HOT_C: f64 = 180.0;
/// Temperature of the hottest place of the pan above which every cooking oil smokes [°C] (refined oils smoke from 200 to 270 °C).
pub const TOO_HOT_C: f64 = 270.0;
/// Mean temperature of the pan's floor below food at which it fries no longer [°C] (chosen: a few kelvins above the
/// boiling point no wet face dries).
pub const TOO_COLD_C: f64 = 120.0;
/// Flow of smoke from which it is spoken of [mg/s] (chosen: ten times the least visible amount, a few milligrams a
/// minute).
pub const SMOKE_SEEN_MG_S: f64 = 0.5;
/// How far the core cools below its peak before the food counts as rested [K] (chosen: far above rounding, soon after the
/// peak).
pub const RESTED_K: f64 = 0.3;
/// Mean temperature below which a face still boils its water off [°C] (chosen: a little above the boiling point, where
/// a face stays as long as water reaches it).
pub const WET_BELOW_C: f64 = 106.0;
/// Share of the way of the core to its goal after which the food is turned for the first time [-] (chosen: both sides
/// get the same heat).
pub const HALF_WAY: f64 = 0.5;
/// Browning index from which a side is brown and the other one has its turn [-] (chosen: a dark crust has 1).
pub const BROWN: f64 = 0.6;
/// Browning index of both sides from which the hob is turned down to finish the core [-] (chosen: they brown on by themselves).
pub const BROWN_BOTH: f64 = 0.7;
/// Browning index of a face from which it is reported to darken [-] (chosen: a dark crust has 1).
pub const BROWN_ENOUGH: f64 = 0.9;
/// Time after which both sides, once brown, change places [s] (chosen: evens out the heat with few flips).
pub const TURNS_S: f64 = 180.0;
/// How near the goal the core would get that food with two brown sides is not turned once more [K] (chosen: half a minute before it is
/// taken out, which evens nothing out any more).
pub const NEARLY_K: f64 = 2.0;
/// Setting of the hob that browns food in a hot pan [W], and the one that lets its core warm on (chosen: the lowest of 400 to 700 W
/// with which steaks of 15 mm get a crust, and one at which steaks of 35 mm do not char; a test of the goals follows them).
pub const FRYING_W: f64 = 650.0;
/// See [`FRYING_W`] [W].
pub const GENTLE_W: f64 = 400.0;
/// Temperature of the hottest place of the pan from which it has the heat to fry on with less power [°C] (chosen: 20 K
/// below [`TOO_HOT_C`]), and the one from which food that has begun to brown browns on [°C] (chosen).
pub const HOT_TO_FRY_C: f64 = 250.0;
/// See [`HOT_TO_FRY_C`] [°C].
pub const BROWNS_AT_C: f64 = 220.0;
/// How much the forecast of the core's peak is too high [K] (tests/advice.rs: 1.1 to 2.4 K for steaks of 18 to 40 mm, as
/// losses through the edges are neglected).
pub const FORECAST_HIGH_K: f64 = 2.0;
/// Distance of the core's goal from the lower bound of its class of doneness [K] (chosen: inside every class, clear of
/// the bound).
pub const GOAL_INTO_CLASS_K: f64 = 2.0;
/// As [`GOAL_INTO_CLASS_K`], for classes by the share of a change [%] (chosen: inside every class, clear of the bound).
pub const GOAL_INTO_CLASS_PCT: f64 = 5.0;

/// Advice with the readings that led to it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Advice {
    /// Turn the hob on: the pan is cold and the hob is off.
    TurnOn {
        /// Setting of the hob that heats a pan well [W].
        power_w: f64,
    },
    /// Wait with the food: the pan is still heating.
    Heating {
        /// Temperature of the pan's floor [°C].
        pan_c: f64,
        /// Temperature to wait for [°C].
        until_c: f64,
    },
    /// Turn the hob down: the oil smokes, or every oil would.
    TooHot {
        /// Temperature of the hottest place of the pan's floor [°C].
        hottest_c: f64,
        /// True if oil smokes visibly.
        smokes: bool,
        /// Setting of the hob that lets the pan cool enough [W].
        to_w: f64,
    },
    /// Turn the hob down: both sides of the food are brown, and only its core is to warm on.
    BothBrown {
        /// Setting of the hob that browns them little further [W].
        to_w: f64,
    },
    /// Turn the hob down to fry: the pan has the heat that it browns with.
    TurnDown {
        /// Temperature of the hottest place of the pan's floor [°C].
        hottest_c: f64,
        /// Setting of the hob that keeps the pan so hot [W].
        to_w: f64,
    },
    /// Turn the hob up: the pan is too cold to fry.
    TooCold {
        /// Setting of the hob that heats a pan well [W].
        power_w: f64,
    },
    /// Turn the hob off: nothing is left to fry.
    TurnOff,
    /// Put the food in: the pan is hot.
    PutIn {
        /// Temperature of the pan's floor [°C].
        pan_c: f64,
    },
    /// Wait: the underside does not brown while it is wet. For food without a scale of doneness.
    Wet {
        /// Temperature of the underside [°C].
        underside_c: f64,
    },
    /// The underside browns. For food without a scale of doneness.
    Browns {
        /// Temperature of the underside [°C].
        underside_c: f64,
    },
    /// Flip the food: half of the heat that it needs is in, its underside is brown, or both sides take turns.
    Flip,
    /// Take the food out: its core will reach the goal while it rests.
    TakeOut {
        /// Highest core temperature to expect [°C].
        peak_c: f64,
    },
    /// Take the food out: the change that measures its doneness has reached the goal at the core.
    Ready {
        /// Share of the change at the core [%].
        share_pct: f64,
    },
    /// Leave the food in: the change has not reached the goal at the core yet.
    NotReady {
        /// Share of the change at the core [%].
        share_pct: f64,
        /// Goal for the share [%].
        until_pct: f64,
    },
    /// Leave the food in: its core would not reach the goal yet.
    WouldPeak {
        /// Highest core temperature to expect if it were taken out now [°C].
        peak_c: f64,
        /// True while the underside is still wet.
        wet: bool,
    },
    /// The food rests, and its core still warms or is near its highest.
    Resting {
        /// Highest temperature that its core has reached [°C].
        peak_c: f64,
        /// True while it still warms.
        warms: bool,
    },
    /// The core has begun to cool: the food has rested.
    Rested {
        /// Highest temperature that its core has reached [°C].
        peak_c: f64,
    },
}

impl Advice {
    /// Returns true if it states that the goal is reached: take it out now.
    pub fn is_goal(self) -> bool {
        matches!(self, Self::TakeOut { .. } | Self::Ready { .. })
    }

    /// Returns the power that the hob should be set to [W]; none of advice that is not about the hob.
    pub fn hob_w(self) -> Option<f64> {
        match self {
            Self::TurnOn { power_w } | Self::TooCold { power_w } => Some(power_w),
            Self::TooHot { to_w, .. } | Self::BothBrown { to_w } | Self::TurnDown { to_w, .. } => Some(to_w),
            Self::TurnOff => Some(0.0),
            _ => None,
        }
    }

    /// Returns true if a cook should act now.
    pub fn is_due(self) -> bool {
        matches!(
            self,
            Self::TurnOn { .. }
                | Self::TooHot { .. }
                | Self::BothBrown { .. }
                | Self::TurnDown { .. }
                | Self::TooCold { .. }
                | Self::TurnOff
                | Self::PutIn { .. }
                | Self::Flip
                | Self::TakeOut { .. }
                | Self::Ready { .. }
        )
    }
}

/// Goal of a cook for food with a scale of doneness.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Goal {
    /// For food whose doneness is measured by the highest temperature.
    Peak {
        /// Target of the highest core temperature [°C].
        core_c: f64,
        /// Highest core temperature that [`crate::piece::carry_over`] foresees if the food were taken out now [°C].
        foreseen_c: f64,
    },
    /// For food whose doneness is measured by the share of a change.
    Share {
        /// Target share at the core [%].
        wanted_pct: f64,
        /// Share at the core now [%].
        reached_pct: f64,
    },
}

/// Goal for the core of a class of doneness, given the index of the class in its scale, in the unit of the scale
/// [°C or %]: inside the class, clear of its lower bound.
pub fn class_goal(scale: &Scale, class: usize) -> f64 {
    scale.from(class)
        + match scale.measure() {
            Measure::Peak => GOAL_INTO_CLASS_K,
            Measure::Share => GOAL_INTO_CLASS_PCT,
        }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Library;

    #[test]
    fn the_goal_of_a_class_lies_in_it() {
        let library = Library::embedded().expect("embedded data");
        for scale in &library.scales {
            for class in 1..scale.class.len() {
                let reached = scale.class_of(scale.of_nodes(class_goal(scale, class)));
                assert_eq!(reached, class, "{} {}", scale.id, scale.class[class].name);
            }
        }
    }
}

//! Advice on the next step, from readings of the kitchen, and the reason why a hob that is on gives no power.

use saute_food::Scale;
use saute_food::change::doneness::Measure;

use crate::{Kitchen, Piece, Place, celsius};

/// Mean temperature of the pan's floor from which food may go in [°C] (chosen: below it a wet face cooks in its own
/// juice before it browns).
pub const WARM_ENOUGH_C: f64 = 160.0;
/// Temperature at which the pan is called hot [°C] (chosen: a drop of water dances, oil does not smoke yet).
pub const HOT_C: f64 = 180.0;
/// Temperature above which every cooking oil smokes [°C] (refined oils smoke from 200 to 270 °C).
pub const TOO_HOT_C: f64 = 270.0;
/// Mean temperature below which a face still boils its water off [°C] (chosen: a little above the boiling point, where
/// a face stays as long as water reaches it).
pub const WET_BELOW_C: f64 = 106.0;
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
        /// Temperature of the pan's floor [°C].
        pan_c: f64,
    },
    /// Wait with the food: the pan is still heating.
    Heating {
        /// Temperature of the pan's floor [°C].
        pan_c: f64,
        /// Temperature to wait for [°C].
        until_c: f64,
    },
    /// Turn the hob down: every oil smokes.
    TooHot {
        /// Temperature of the pan's floor [°C].
        pan_c: f64,
        /// Temperature above which every oil smokes [°C].
        most_c: f64,
    },
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
    /// Take the food out: its core will reach the goal while it rests.
    TakeOut {
        /// Highest core temperature to expect [°C].
        peak_c: f64,
    },
    /// Take the food out: the change that its doneness is told by has reached the goal at the core.
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
    /// The food rests.
    Resting {
        /// Highest temperature that its core has reached [°C].
        peak_c: f64,
    },
}

impl Advice {
    /// Returns true if a cook should act now.
    pub fn is_due(self) -> bool {
        matches!(self, Self::TooHot { .. } | Self::PutIn { .. } | Self::TakeOut { .. } | Self::Ready { .. })
    }
}

/// Goal of a cook for food with a scale of doneness.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Goal {
    /// For food whose doneness is told by the highest temperature.
    Peak {
        /// Wanted highest core temperature [°C].
        core_c: f64,
        /// Highest core temperature to expect if the food were taken out now [°C] (see [`crate::piece::carry_over`]).
        foreseen_c: f64,
    },
    /// For food whose doneness is told by the share of a change.
    Share {
        /// Wanted share at the core [%].
        wanted_pct: f64,
        /// Share at the core now [%].
        reached_pct: f64,
    },
}

/// Readings from which advice is derived.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Situation {
    /// Where the piece is.
    pub place: Place,
    /// Temperature of the pan's floor [°C].
    pub pan_c: f64,
    /// True if the hob is turned on.
    pub hob_is_on: bool,
    /// Mean temperature of the piece's underside [°C].
    pub underside_c: f64,
    /// Highest temperature that its core has reached [°C].
    pub core_peak_c: f64,
}

impl Situation {
    /// Reads the situation of a piece.
    pub fn of(kitchen: &Kitchen, piece: &Piece) -> Self {
        Self {
            place: piece.place,
            pan_c: celsius(kitchen.pan_temperature()),
            hob_is_on: kitchen.hob_w() != 0.0,
            underside_c: celsius(piece.face(true)),
            core_peak_c: celsius(piece.core_peak.0),
        }
    }

    /// Returns what to do next, or `None` if nothing needs to be done. Without a goal the advice is about the underside.
    pub fn advice(&self, goal: Option<Goal>) -> Option<Advice> {
        match self.place {
            Place::Waiting => Some(self.before()),
            Place::Pan(_) if self.pan_c > TOO_HOT_C => Some(self.too_hot()),
            Place::Pan(_) => Some(self.in_pan(goal)),
            Place::Rest(_) => Some(Advice::Resting { peak_c: self.core_peak_c }),
            _ => None,
        }
    }

    fn before(&self) -> Advice {
        let pan_c = self.pan_c;
        match () {
            () if pan_c < WARM_ENOUGH_C && !self.hob_is_on => Advice::TurnOn { pan_c },
            () if pan_c < WARM_ENOUGH_C => Advice::Heating { pan_c, until_c: HOT_C },
            () if pan_c > TOO_HOT_C => self.too_hot(),
            () => Advice::PutIn { pan_c },
        }
    }

    fn too_hot(&self) -> Advice {
        Advice::TooHot { pan_c: self.pan_c, most_c: TOO_HOT_C }
    }

    fn in_pan(&self, goal: Option<Goal>) -> Advice {
        let (underside_c, wet) = (self.underside_c, self.underside_c < WET_BELOW_C);
        match goal {
            None if wet => Advice::Wet { underside_c },
            None => Advice::Browns { underside_c },
            Some(Goal::Peak { core_c, foreseen_c }) if foreseen_c >= core_c => Advice::TakeOut { peak_c: foreseen_c },
            Some(Goal::Peak { foreseen_c, .. }) => Advice::WouldPeak { peak_c: foreseen_c, wet },
            Some(Goal::Share { wanted_pct, reached_pct }) if reached_pct >= wanted_pct => {
                Advice::Ready { share_pct: reached_pct }
            }
            Some(Goal::Share { wanted_pct, reached_pct }) => {
                Advice::NotReady { share_pct: reached_pct, until_pct: wanted_pct }
            }
        }
    }
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

/// Why a hob that is on gives no power.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoPower {
    /// The pan stands on the wet cloth.
    Cloth,
    /// The pan is at the hob's limit of temperature.
    Limit,
    /// The pan is lifted.
    Lifted,
    /// The pan stands off the ring.
    OffRing,
}

impl NoPower {
    /// Returns why a hob that is on gives no power, or `None` if it is off or gives power.
    pub fn of(kitchen: &Kitchen) -> Option<Self> {
        let (pan, on) = (kitchen.pan_state(), kitchen.hob_w() > 0.0);
        match () {
            () if !on || kitchen.hob_drawn_w() > 0.0 => None,
            () if kitchen.cloth().is_some() => Some(Self::Cloth),
            () if pan.limited => Some(Self::Limit),
            // The pan is as hot as the hob holds it.
            () if kitchen.hob_holds().is_some() && kitchen.hob().detects(&pan.pose) => None,
            () if pan.pose.lift > 0.0 => Some(Self::Lifted),
            () => Some(Self::OffRing),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Command, Library, RestOn};

    const RAW: Situation =
        Situation { place: Place::Waiting, pan_c: 20.0, hob_is_on: false, underside_c: 5.0, core_peak_c: 5.0 };
    const FRYING: Situation =
        Situation { place: Place::Pan([0.0; 2]), pan_c: 200.0, hob_is_on: true, underside_c: 140.0, core_peak_c: 40.0 };

    #[test]
    fn food_waits_until_the_pan_is_hot() {
        let at = |pan_c, hob_is_on| Situation { pan_c, hob_is_on, ..RAW }.advice(None);
        assert_eq!(at(20.0, false), Some(Advice::TurnOn { pan_c: 20.0 }));
        assert_eq!(at(159.0, true), Some(Advice::Heating { pan_c: 159.0, until_c: 180.0 }));
        assert_eq!(at(161.0, false), Some(Advice::PutIn { pan_c: 161.0 }));
        assert_eq!(at(271.0, true), Some(Advice::TooHot { pan_c: 271.0, most_c: 270.0 }));
    }

    #[test]
    fn a_pan_that_smokes_comes_before_every_goal() {
        let goal = Some(Goal::Peak { core_c: 55.0, foreseen_c: 60.0 });
        let advice = Situation { pan_c: 275.0, ..FRYING }.advice(goal);
        assert!(matches!(advice, Some(Advice::TooHot { .. })), "{advice:?}");
    }

    #[test]
    fn food_comes_out_when_resting_would_bring_it_to_the_goal() {
        let at = |foreseen_c| FRYING.advice(Some(Goal::Peak { core_c: 55.0, foreseen_c }));
        assert_eq!(at(54.9), Some(Advice::WouldPeak { peak_c: 54.9, wet: false }));
        assert_eq!(at(55.0), Some(Advice::TakeOut { peak_c: 55.0 }));
    }

    #[test]
    fn food_that_softens_comes_out_when_its_core_has_softened_enough() {
        let at = |reached_pct| FRYING.advice(Some(Goal::Share { wanted_pct: 50.0, reached_pct }));
        assert_eq!(at(49.9), Some(Advice::NotReady { share_pct: 49.9, until_pct: 50.0 }));
        assert_eq!(at(50.0), Some(Advice::Ready { share_pct: 50.0 }));
        assert!(at(50.0).is_some_and(Advice::is_due) && !at(10.0).is_some_and(Advice::is_due));
    }

    #[test]
    fn the_goal_of_a_class_lies_in_the_class() {
        let library = Library::embedded().expect("embedded data");
        for scale in &library.scales {
            for class in 1..scale.class.len() {
                let reached = scale.class_of(scale.of_nodes(class_goal(scale, class)));
                assert_eq!(reached, class, "{} {}", scale.id, scale.class[class].name);
            }
        }
    }

    #[test]
    fn an_underside_is_wet_until_its_water_has_boiled_off() {
        let at = |underside_c| Situation { underside_c, ..FRYING };
        assert_eq!(at(105.9).advice(None), Some(Advice::Wet { underside_c: 105.9 }));
        assert_eq!(at(106.0).advice(None), Some(Advice::Browns { underside_c: 106.0 }));
        let goal = Some(Goal::Peak { core_c: 55.0, foreseen_c: 30.0 });
        assert_eq!(at(100.0).advice(goal), Some(Advice::WouldPeak { peak_c: 30.0, wet: true }));
    }

    #[test]
    fn resting_food_is_left_alone_and_held_food_needs_no_advice() {
        let at = |place| Situation { place, ..FRYING }.advice(None);
        assert_eq!(at(Place::Rest(RestOn::Board)), Some(Advice::Resting { peak_c: 40.0 }));
        assert_eq!(at(Place::Held), None);
    }

    #[test]
    fn only_advice_to_act_is_due() {
        let due = |situation: Situation| situation.advice(None).is_some_and(Advice::is_due);
        assert!(!due(RAW) && due(Situation { pan_c: 200.0, ..RAW }) && !due(FRYING));
    }

    #[test]
    fn a_hob_that_is_on_gives_no_power_to_a_pan_on_the_cloth() {
        let library = Library::embedded().expect("embedded data");
        let mut kitchen = Kitchen::new(&library, "carbon-steel-26", 293.15).expect("sets up");
        assert_eq!(NoPower::of(&kitchen), None, "off");
        kitchen.apply(&Command::Hob(1000.0)).expect("hob");
        kitchen.step();
        assert_eq!(NoPower::of(&kitchen), None, "on");
        kitchen.apply(&Command::Cool { for_s: 10.0 }).expect("cloth");
        assert_eq!(NoPower::of(&kitchen), Some(NoPower::Cloth));
    }
}

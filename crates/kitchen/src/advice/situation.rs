//! Readings of the kitchen and of one piece, and the advice that follows from them.

use super::{
    Advice, BROWN, BROWN_BOTH, BROWNS_AT_C, FORECAST_HIGH_K, FRYING_W, GENTLE_W, Goal, HALF_WAY, HOT_C, HOT_TO_FRY_C,
    NEARLY_K, RESTED_K, SMOKE_SEEN_MG_S, TOO_COLD_C, TOO_HOT_C, TURNS_S, WARM_ENOUGH_C, WET_BELOW_C,
};
use crate::pan::heater::HeaterKind;
use crate::pan::hob::HobDescription;
use crate::pan::hold::Holding;
use crate::{Kitchen, Piece, Place, celsius};

/// Readings from which advice is derived.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Situation {
    /// Where the piece is.
    pub place: Place,
    /// Temperature of the pan's floor [°C].
    pub pan_c: f64,
    /// Temperature of the hottest place of the pan's floor [°C].
    pub hottest_c: f64,
    /// True if food is in the pan.
    pub pan_is_used: bool,
    /// What heats the pan.
    pub heated_by: HeaterKind,
    /// Power to which the hob is set, as that of an induction hob which gives the pan as much [W].
    pub hob_w: f64,
    /// Temperature at which the hob holds the pan [°C], and how far it is; none of a hob that gives what it is set to.
    pub held: Option<(f64, Holding)>,
    /// Setting of the hob that heats a pan well, as [`Self::hob_w`] [W].
    pub heating_w: f64,
    /// Flow of smoke [mg/s].
    pub smoke_mg_s: f64,
    /// Mean temperature of the piece's underside [°C].
    pub underside_c: f64,
    /// Mean browning index of its underside and of its upper side, on ridges of the bars [-].
    pub browning: [f64; 2],
    /// Time since it was last flipped [s]; none if it never was.
    pub since_flip_s: Option<f64>,
    /// Temperature of the room [°C].
    pub room_c: f64,
    /// Temperature of its core now [°C].
    pub core_c: f64,
    /// Highest temperature that its core has reached [°C].
    pub core_peak_c: f64,
}

/// Excess of the hottest place of a pan over the room's temperature for each watt of the hob's setting, with food in the pan and in
/// the long run [K/W] (0.42 to 0.51 with a steak of 35 mm in aluminium, cast iron and carbon steel at 500 W).
const KELVIN_PER_W: f64 = 0.45;
/// How far a pan that is too hot should cool [K] (chosen: the flow of smoke falls to a fraction).
const COOLER_K: f64 = 30.0;
/// Step in which powers are named [W] (chosen: easily set with a slider).
const STEP_W: f64 = 100.0;

impl Situation {
    /// Reads the situation of a piece.
    pub fn of(kitchen: &Kitchen, piece: &Piece) -> Self {
        let up = piece.up();
        let browning = |up| piece.model.face_browning(&piece.state, up);
        Self {
            place: piece.place,
            pan_c: celsius(kitchen.pan_temperature()),
            hottest_c: celsius(kitchen.hottest_temperature()),
            pan_is_used: kitchen.pieces().iter().any(Piece::in_pan),
            heated_by: kitchen.hob().heater().map_or(HeaterKind::Coil, |heater| heater.kind()),
            hob_w: as_on_induction(kitchen.hob(), kitchen.hob_w()),
            held: kitchen.hob_holds().map(celsius).zip(kitchen.holding()),
            heating_w: as_on_induction(kitchen.hob(), heating_w(kitchen.hob())),
            smoke_mg_s: kitchen.pan_state().smoke_mg_s(),
            underside_c: celsius(piece.face(true)),
            browning: [browning(up), browning(up.map(|u| -u))],
            since_flip_s: piece.flipped_at().map(|at| kitchen.time_s() - at),
            room_c: celsius(kitchen.room().temperature()),
            core_c: celsius(piece.core()),
            core_peak_c: celsius(piece.core_peak.0),
        }
    }

    /// Returns what to do, the most urgent first: what the food needs now, then the hob, then what to wait for. Without a
    /// goal the advice is about the underside.
    pub fn advice(&self, goal: Option<Goal>) -> Vec<Advice> {
        match self.place {
            Place::Waiting => vec![self.too_hot().unwrap_or_else(|| self.before())],
            Place::Pan(_) => self.in_pan(goal),
            Place::Rest(_) => self.off_the_pan(),
            _ => Vec::new(),
        }
    }

    fn before(&self) -> Advice {
        let pan_c = self.pan_c;
        match self.held {
            Some((until_c, Holding::Warms)) => return Advice::Heating { pan_c, until_c },
            Some(_) => return Advice::PutIn { pan_c },
            None => {}
        }
        match () {
            () if pan_c >= WARM_ENOUGH_C => Advice::PutIn { pan_c },
            () if self.hob_w > 0.0 => Advice::Heating { pan_c, until_c: WARM_ENOUGH_C },
            () => Advice::TurnOn { power_w: self.heating_w },
        }
    }

    fn too_hot(&self) -> Option<Advice> {
        let (hottest_c, smokes) = (self.hottest_c, self.smoke_mg_s >= SMOKE_SEEN_MG_S);
        let to_w = self.power_for(hottest_c - COOLER_K).min(FRYING_W);
        // With the hob at that setting the pan cools by itself.
        let is_due = (smokes || hottest_c > TOO_HOT_C) && self.is_above(to_w);
        is_due.then_some(Advice::TooHot { hottest_c, smokes, to_w })
    }

    /// Both sides are as brown as they should be, and the pan would brown them on.
    fn both_brown(&self) -> Option<Advice> {
        let brown = self.browning.iter().all(|b| *b >= BROWN_BOTH) && self.hottest_c > HOT_C;
        (brown && self.is_above(GENTLE_W)).then_some(Advice::BothBrown { to_w: GENTLE_W })
    }

    /// True if the hob is set to more than a power, by a step at least.
    fn is_above(&self, watts: f64) -> bool {
        self.hob_w >= watts + STEP_W
    }

    /// A hob that was turned up to heat the pan is turned down once the food browns, or the pan is hotter than it needs.
    fn turn_down(&self) -> Option<Advice> {
        let browns = self.browning.iter().any(|b| *b >= BROWN) && self.hottest_c >= BROWNS_AT_C;
        let is_due = (browns || self.hottest_c >= HOT_TO_FRY_C) && self.is_above(FRYING_W);
        is_due.then_some(Advice::TurnDown { hottest_c: self.hottest_c, to_w: FRYING_W })
    }

    /// Setting of the hob that keeps the hottest place of a pan with food in it at a temperature [W], in steps that a cook sets.
    fn power_for(&self, hottest_c: f64) -> f64 {
        STEP_W * libm::floor((hottest_c - self.room_c).max(0.0) / KELVIN_PER_W / STEP_W)
    }

    fn too_cold(&self) -> Option<Advice> {
        let cold = self.pan_c < TOO_COLD_C && self.hob_w < self.heating_w;
        cold.then_some(Advice::TooCold { power_w: self.heating_w })
    }

    fn in_pan(&self, goal: Option<Goal>) -> Vec<Advice> {
        let food = self.of_food(goal);
        let cooler = self.too_hot().or_else(|| self.both_brown());
        // What the hob holds needs no hand on the dial.
        let by_hand = || self.turn_down().or_else(|| self.too_cold()).filter(|_| self.held.is_none());
        let hob = cooler.or_else(by_hand);
        let mut advice: Vec<Advice> = [Some(food), hob].into_iter().flatten().collect();
        // What is due comes before what is waited for; food before the hob.
        advice.sort_by_key(|one| !one.is_due());
        advice
    }

    fn of_food(&self, goal: Option<Goal>) -> Advice {
        let (underside_c, wet) = (self.underside_c, self.underside_c < WET_BELOW_C);
        let goal = goal.map(Goal::corrected);
        match goal {
            None if wet => Advice::Wet { underside_c },
            None => Advice::Browns { underside_c },
            Some(Goal::Peak { core_c, foreseen_c }) if foreseen_c >= core_c => Advice::TakeOut { peak_c: foreseen_c },
            Some(Goal::Peak { core_c, foreseen_c }) if self.wants_flip(core_c, foreseen_c) => Advice::Flip,
            Some(Goal::Peak { foreseen_c, .. }) => Advice::WouldPeak { peak_c: foreseen_c, wet },
            Some(Goal::Share { wanted_pct, reached_pct }) if reached_pct >= wanted_pct => {
                Advice::Ready { share_pct: reached_pct }
            }
            Some(Goal::Share { wanted_pct, reached_pct }) => {
                Advice::NotReady { share_pct: reached_pct, until_pct: wanted_pct }
            }
        }
    }

    /// The first time once half of the heat is in or the underside is brown; then the other side browns, and from then on both take
    /// turns.
    fn wants_flip(&self, goal_c: f64, foreseen_c: f64) -> bool {
        let [is_brown, was_brown] = self.browning.map(|b| b >= BROWN);
        let half = self.room_c + HALF_WAY * (goal_c - self.room_c);
        match self.since_flip_s {
            None => is_brown || foreseen_c >= half,
            Some(since_s) => is_brown && (!was_brown || (since_s >= TURNS_S && foreseen_c < goal_c - NEARLY_K)),
        }
    }

    fn off_the_pan(&self) -> Vec<Advice> {
        let peak_c = self.core_peak_c;
        let rests = match self.core_c {
            c if c > peak_c - RESTED_K => Advice::Resting { peak_c, warms: c >= peak_c },
            _ => Advice::Rested { peak_c },
        };
        let idle = self.hob_w > 0.0 && !self.pan_is_used;
        idle.then_some(Advice::TurnOff).into_iter().chain([rests]).collect()
    }
}

impl Goal {
    /// The goal with the forecast that is to be expected by experience.
    fn corrected(self) -> Self {
        match self {
            Self::Peak { core_c, foreseen_c } => Self::Peak { core_c, foreseen_c: foreseen_c - FORECAST_HIGH_K },
            share @ Self::Share { .. } => share,
        }
    }
}

/// Heat into the pan that heats it in a few minutes [W] (chosen: the middle of an induction hob's dial).
const HEATING_W: f64 = 950.0;

/// The setting of a hob that gives about that heat [W].
fn heating_w(hob: &HobDescription) -> f64 {
    let off = |w: &f64| libm::fabs(hob.heat_at(*w) - HEATING_W);
    let settings = hob.settings_w().iter().copied().filter(|w| *w > 0.0);
    settings.min_by(|a, b| off(a).total_cmp(&off(b))).unwrap_or(0.0)
}

/// Powers with which people cook on a hob, ascending [W]: those of its dial, and the one at which the coach fries, where it can be set.
pub fn usual_powers_w(hob: &HobDescription) -> Vec<f64> {
    let frying = in_place_of_induction(hob, FRYING_W);
    let can_be_set = frying <= hob.largest_w() && hob.nearest_w(frying) == frying;
    let dial = hob.settings_w().iter().copied().filter(|w| *w > 0.0);
    let mut powers: Vec<f64> = dial.chain(can_be_set.then_some(frying)).collect();
    powers.sort_by(f64::total_cmp);
    powers.dedup();
    powers
}

/// Share of an induction hob's power that reaches the pan [-] (that of the shipped one).
const INDUCTION: f64 = 0.87;

/// Power of an induction hob that gives a pan in the long run what a hob gives it at `power` [W].
fn as_on_induction(hob: &HobDescription, power: f64) -> f64 {
    if hob.coil.is_some() { power } else { hob.heat_at(power) / INDUCTION }
}

/// Power of a hob that gives a pan what an induction hob gives it at `power`, to 10 W [W].
fn in_place_of_induction(hob: &HobDescription, power: f64) -> f64 {
    if hob.coil.is_some() { power } else { 10.0 * libm::round(0.1 * hob.power_for(INDUCTION * power)) }
}

impl Advice {
    /// The same advice with the power that a hob is to be set to, in place of that of an induction hob.
    fn on(self, hob: &HobDescription) -> Self {
        if hob.coil.is_some() {
            return self;
        }
        let power = |w: f64| hob.nearest_w(in_place_of_induction(hob, w));
        match self {
            Self::TurnOn { power_w } => Self::TurnOn { power_w: power(power_w) },
            Self::TooCold { power_w } => Self::TooCold { power_w: power(power_w) },
            Self::TooHot { hottest_c, smokes, to_w } => Self::TooHot { hottest_c, smokes, to_w: power(to_w) },
            Self::BothBrown { to_w } => Self::BothBrown { to_w: power(to_w) },
            Self::TurnDown { hottest_c, to_w } => Self::TurnDown { hottest_c, to_w: power(to_w) },
            other => other,
        }
    }
}

/// Returns what to do about a piece, as [`Situation::advice`], with powers that the kitchen's hob has.
pub fn advise(kitchen: &Kitchen, piece: &Piece, goal: Option<Goal>) -> Vec<Advice> {
    let hob = kitchen.hob();
    let all = Situation::of(kitchen, piece).advice(goal).into_iter().map(|one| one.on(hob));
    // A dial with few steps may have none between its position and the wished one.
    let is_new = |one: &Advice| one.hob_w().is_none_or(|w| libm::fabs(w - kitchen.hob_w()) > 0.5);
    all.filter(|one| hob.coil.is_some() || is_new(one)).collect()
}

#[cfg(test)]
impl Situation {
    /// A raw steak before a cold pan.
    pub(super) const RAW: Self = Self {
        place: Place::Waiting,
        pan_c: 20.0,
        hottest_c: 20.0,
        pan_is_used: false,
        heated_by: HeaterKind::Coil,
        hob_w: 0.0,
        held: None,
        heating_w: 1100.0,
        smoke_mg_s: 0.0,
        underside_c: 5.0,
        browning: [0.0; 2],
        since_flip_s: None,
        room_c: 20.0,
        core_c: 5.0,
        core_peak_c: 5.0,
    };
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::RestOn;

    const FRYING: Situation = Situation {
        place: Place::Pan([0.0; 2]),
        pan_c: 200.0,
        hottest_c: 215.0,
        pan_is_used: true,
        hob_w: 1100.0,
        underside_c: 140.0,
        core_c: 40.0,
        core_peak_c: 40.0,
        ..Situation::RAW
    };

    /// A goal of 60 °C, and the peak to expect.
    fn peak(expected_c: f64) -> Option<Goal> {
        Some(Goal::Peak { core_c: 60.0, foreseen_c: expected_c + FORECAST_HIGH_K })
    }

    #[test]
    fn food_waits_until_the_pan_is_hot() {
        let at = |pan_c, hob_w| Situation { pan_c, hob_w, ..Situation::RAW }.advice(None);
        assert_eq!(at(20.0, 0.0), [Advice::TurnOn { power_w: 1100.0 }]);
        assert_eq!(at(159.0, 400.0), [Advice::Heating { pan_c: 159.0, until_c: 160.0 }]);
        assert_eq!(at(161.0, 0.0), [Advice::PutIn { pan_c: 161.0 }]);
        let hot = Situation { pan_c: 240.0, hottest_c: 271.0, hob_w: 1100.0, ..Situation::RAW };
        assert_eq!(hot.advice(None), [Advice::TooHot { hottest_c: 271.0, smokes: false, to_w: 400.0 }]);
    }

    #[test]
    fn food_waits_for_the_dial_of_a_hob_that_holds_and_nobody_turns_it_while_it_fries() {
        let held = |held_c, holding| Situation { hob_w: 1800.0, held: Some((held_c, holding)), ..Situation::RAW };
        let at = |pan_c, situation: Situation| Situation { pan_c, ..situation }.advice(None);
        let warms = held(200.0, Holding::Warms);
        assert_eq!(
            at(175.0, warms),
            [Advice::Heating { pan_c: 175.0, until_c: 200.0 }],
            "hot, but not as hot as wished"
        );
        assert_eq!(at(198.0, held(200.0, Holding::Reached)), [Advice::PutIn { pan_c: 198.0 }]);
        assert_eq!(at(138.0, held(140.0, Holding::Reached)), [Advice::PutIn { pan_c: 138.0 }], "gently, as wished");
        let fries = Situation { hob_w: 1800.0, hottest_c: 255.0, held: warms.held, ..FRYING };
        assert!(!fries.advice(None)[0].is_due() && !Situation { pan_c: 119.0, ..fries }.advice(None)[0].is_due());
        assert!(Situation { held: None, ..fries }.advice(None)[0].is_due(), "by hand it would be turned down");
    }

    #[test]
    fn food_that_is_ready_comes_before_a_pan_that_is_too_hot_and_both_are_said() {
        let hot = Situation { hottest_c: 275.0, ..FRYING };
        let too_hot = Advice::TooHot { hottest_c: 275.0, smokes: false, to_w: 500.0 };
        assert_eq!(hot.advice(peak(60.0)), [Advice::TakeOut { peak_c: 60.0 }, too_hot]);
        assert_eq!(hot.advice(peak(30.0)), [too_hot, Advice::WouldPeak { peak_c: 30.0, wet: false }]);
    }

    #[test]
    fn a_hob_that_was_turned_down_for_heat_is_not_turned_down_again_while_the_pan_cools() {
        let at = |hottest_c, hob_w| Situation { hottest_c, hob_w, smoke_mg_s: 2.0, ..FRYING }.advice(None)[0];
        assert_eq!(at(275.0, 1100.0), Advice::TooHot { hottest_c: 275.0, smokes: true, to_w: 500.0 });
        assert!(!at(275.0, 500.0).is_due() && !at(240.0, 400.0).is_due());
        assert_eq!(at(200.0, 500.0), Advice::TooHot { hottest_c: 200.0, smokes: true, to_w: 300.0 });
        assert_eq!(at(390.0, 1100.0), Advice::TooHot { hottest_c: 390.0, smokes: true, to_w: FRYING_W });
    }

    #[test]
    fn a_pan_that_is_hot_enough_to_fry_gets_less_power_once() {
        let down = |hottest_c| Advice::TurnDown { hottest_c, to_w: FRYING_W };
        let at = |hottest_c, hob_w, below| {
            Situation { hottest_c, hob_w, browning: [below, 0.0], since_flip_s: Some(5.0), ..FRYING }.advice(None)[0]
        };
        assert_eq!(at(250.0, 1100.0, 0.0), down(250.0));
        assert!(!at(249.0, 1100.0, 0.0).is_due() && !at(260.0, FRYING_W, 0.0).is_due());
        assert_eq!(at(225.0, 1100.0, BROWN), down(225.0), "what browns needs no more");
        assert!(!at(215.0, 1100.0, BROWN).is_due(), "it would not brown on");
    }

    #[test]
    fn smoke_that_nobody_sees_is_not_spoken_of() {
        let at = |smoke_mg_s| Situation { smoke_mg_s, ..FRYING }.advice(None);
        assert_eq!(at(0.04), [Advice::Browns { underside_c: 140.0 }]);
        assert_eq!(at(0.5)[0], Advice::TooHot { hottest_c: 215.0, smokes: true, to_w: 300.0 });
    }

    #[test]
    fn food_comes_out_when_resting_would_bring_it_to_the_goal() {
        let at = |foreseen_c| Situation { since_flip_s: Some(60.0), ..FRYING }.advice(peak(foreseen_c));
        assert_eq!(at(59.9), [Advice::WouldPeak { peak_c: 59.9, wet: false }]);
        assert_eq!(at(60.0), [Advice::TakeOut { peak_c: 60.0 }]);
    }

    #[test]
    fn food_is_flipped_half_way_or_brown_then_sides_take_turns() {
        let at = |since_flip_s, browning, foreseen_c| {
            Situation { since_flip_s, browning, ..FRYING }.advice(peak(foreseen_c))[0] == Advice::Flip
        };
        assert!(!at(None, [0.3, 0.0], 39.9) && at(None, [0.3, 0.0], 40.0) && at(None, [BROWN, 0.0], 30.0));
        assert!(!at(Some(300.0), [0.3, 0.5], 50.0), "the second side browns");
        assert!(at(Some(20.0), [BROWN, 0.5], 50.0), "it is brown, the other one is not");
        assert!(!at(Some(179.0), [0.7, 0.7], 50.0) && at(Some(180.0), [0.7, 0.7], 50.0));
    }

    #[test]
    fn the_hob_is_turned_down_once_when_both_sides_are_brown() {
        let at =
            |hob_w, browning| Situation { hob_w, browning, since_flip_s: Some(5.0), ..FRYING }.advice(peak(50.0))[0];
        let gentle = Advice::BothBrown { to_w: GENTLE_W };
        assert_eq!(at(FRYING_W, [BROWN_BOTH; 2]), gentle);
        assert!(!at(GENTLE_W, [0.9; 2]).is_due() && !at(FRYING_W, [0.5, 0.9]).is_due());
    }

    #[test]
    fn food_that_softens_comes_out_when_its_core_has_softened_enough() {
        let at = |reached_pct| FRYING.advice(Some(Goal::Share { wanted_pct: 50.0, reached_pct }));
        assert_eq!(at(49.9), [Advice::NotReady { share_pct: 49.9, until_pct: 50.0 }]);
        assert_eq!(at(50.0), [Advice::Ready { share_pct: 50.0 }]);
        assert!(at(50.0)[0].is_due() && !at(10.0)[0].is_due());
    }

    #[test]
    fn an_underside_is_wet_until_its_water_has_boiled_off() {
        let at = |underside_c| Situation { underside_c, ..FRYING };
        assert_eq!(at(105.9).advice(None), [Advice::Wet { underside_c: 105.9 }]);
        assert_eq!(at(106.0).advice(None), [Advice::Browns { underside_c: 106.0 }]);
        assert_eq!(at(100.0).advice(peak(30.0)), [Advice::WouldPeak { peak_c: 30.0, wet: true }]);
    }

    #[test]
    fn a_pan_that_no_longer_fries_is_heated_and_an_empty_one_is_not() {
        let cold = Situation { pan_c: 119.0, hob_w: 400.0, ..FRYING };
        assert_eq!(cold.advice(None)[0], Advice::TooCold { power_w: 1100.0 });
        assert!(!Situation { hob_w: 1100.0, ..cold }.advice(None)[0].is_due(), "it is being heated");
        let out = Situation { place: Place::Rest(RestOn::Board), pan_is_used: false, ..FRYING };
        assert_eq!(out.advice(None), [Advice::TurnOff, Advice::Resting { peak_c: 40.0, warms: true }]);
    }

    #[test]
    fn food_rests_until_its_core_cools_and_held_food_needs_no_advice() {
        let at = |place, core_c| Situation { place, core_c, hob_w: 0.0, ..FRYING }.advice(None);
        assert_eq!(at(Place::Rest(RestOn::Board), 40.0), [Advice::Resting { peak_c: 40.0, warms: true }]);
        assert_eq!(at(Place::Rest(RestOn::Board), 39.9), [Advice::Resting { peak_c: 40.0, warms: false }]);
        assert_eq!(at(Place::Rest(RestOn::Board), 39.6), [Advice::Rested { peak_c: 40.0 }]);
        assert_eq!(at(Place::Held, 40.0), []);
    }
}

//! What happens and why, and the next cue to look, listen or feel for: chosen by rule from readings of the kitchen.
//!
//! The cues are those of a cook without a thermometer. Where the model computes what they show (water that boils off, browning,
//! smoke, the core), the rule reads it; how it looks, sounds or feels is from reports of cooks, and chosen.

use super::{Advice, BROWN_ENOUGH, HOT_C, SMOKE_SEEN_MG_S, Situation, WARM_ENOUGH_C, WET_BELOW_C};
use crate::pan::heater::HeaterKind;
use crate::{Kitchen, Piece, Place};

/// Temperature of a dry face from which it browns before one's eyes [°C] (chosen: the browning of `data/kinetics` takes minutes
/// there, and hours at the boiling point).
pub const BROWNS_FROM_C: f64 = 140.0;
/// Mean temperature of a face from which its water boils off [°C] (chosen: parts of it have reached the boiling point).
const BOILS_FROM_C: f64 = 90.0;
/// Browning index from which a crust is seen [-] (chosen: the faces count as browned from there).
const CRUST_SEEN: f64 = 0.5;
/// Share of a piece's fat that has left it from which it is reported to render [-] (chosen: the pan glistens), and share of its mass
/// that is fat from which that is worth a word [-] (chosen: marbled meat has more, lean meat less).
const RENDERED: f64 = 0.01;
const FATTY: f64 = 0.08;
/// Distance of the core from its goal below which its touch shows it [K] (chosen: half a class of doneness), and share of the goal
/// of a change that shows the same [-] (chosen).
const NEAR_K: f64 = 5.0;
const NEAR_SHARE: f64 = 0.6;
/// Core from which pressed juice is on the upper face [°C] (chosen: myosin lets go of water from about 50 °C).
const JUICE_FROM_C: f64 = 48.0;

/// What happens now, and with it why.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Happening {
    /// The pan is cold, and nothing heats it.
    PanIsCold,
    /// The pan's floor heats: by the field of a hob from within, or by a flame, a glass or a plate from below.
    PanHeats {
        /// Temperature of the floor [°C].
        pan_c: f64,
        /// What heats it.
        by: HeaterKind,
    },
    /// The pan is hot: it stores the heat that boils off the first water.
    PanIsHot {
        /// Temperature of the floor [°C].
        pan_c: f64,
    },
    /// The oil breaks down.
    OilSmokes,
    /// The cold underside warms on the pan; its water will boil.
    FaceWarms {
        /// Temperature of the underside [°C].
        underside_c: f64,
    },
    /// Water boils off the underside and keeps it near 100 °C.
    WaterBoilsOff {
        /// Temperature of the underside [°C].
        underside_c: f64,
    },
    /// The underside is dry: evaporation no longer keeps it at 100 °C.
    FaceDries {
        /// Temperature of the underside [°C].
        underside_c: f64,
    },
    /// The dry underside browns.
    Browns {
        /// Temperature of the underside [°C].
        underside_c: f64,
    },
    /// The crust is dark; from here it chars.
    CrustDarkens,
    /// Fat melts and runs out.
    FatRenders,
    /// Heat goes inwards by conduction, and the core lags behind the faces.
    CoreLags {
        /// Temperature of the core [°C].
        core_c: f64,
    },
    /// Heat loosens the walls of the cells.
    Softens {
        /// Share of the change at the core [%].
        share_pct: f64,
    },
    /// The hot outer layers of a resting piece warm its core.
    CarriesOver {
        /// Temperature of the core [°C].
        core_c: f64,
    },
    /// The temperatures have evened out.
    Rested,
}

/// The next thing to perceive.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cue {
    /// Look: the oil flows like water and shimmers.
    OilShimmers,
    /// Look: a drop of water dances on the dry pan.
    DropDances,
    /// Listen: a lively sizzle as the food goes in.
    LivelySizzle,
    /// Look: the smoke stops.
    SmokeStops,
    /// Listen: the bubbling sizzle fades to a crackle.
    SizzleFades,
    /// Look: brown creeps up at the edge.
    EdgeBrowns,
    /// Look: steam rises at the sides.
    SteamAtSides,
    /// Look: beads of juice on the upper face.
    JuiceBeads,
    /// Feel: it springs back under a finger.
    Firmer,
    /// Look: it curls and turns from glassy to opaque.
    CurlsOpaque,
    /// Feel: the tip of a knife slides in.
    KnifeSlides,
    /// Feel: it is warm on top, no longer hot.
    WarmOnTop,
}

/// The sense that a cue is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sense {
    /// Look.
    Look,
    /// Listen.
    Listen,
    /// Feel.
    Feel,
}

impl Cue {
    /// Returns the sense that it is for.
    pub fn sense(self) -> Sense {
        match self {
            Self::LivelySizzle | Self::SizzleFades => Sense::Listen,
            Self::Firmer | Self::KnifeSlides | Self::WarmOnTop => Sense::Feel,
            Self::OilShimmers
            | Self::DropDances
            | Self::SmokeStops
            | Self::EdgeBrowns
            | Self::SteamAtSides
            | Self::JuiceBeads
            | Self::CurlsOpaque => Sense::Look,
        }
    }
}

/// What a coach states of a piece: what happens and why, and what to perceive next.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coaching {
    /// What happens now.
    pub happening: Happening,
    /// The next cue; none where there is nothing to wait for.
    pub cue: Option<Cue>,
}

/// What the rules read.
#[derive(Clone, Copy, Debug)]
struct Readings {
    situation: Situation,
    /// True if oil is in the pan.
    oiled: bool,
    /// True if fat runs out of the piece, and it has much of it.
    renders: bool,
    /// True of a body that curls.
    curls: bool,
    /// What is advised first.
    advice: Option<Advice>,
}

impl Coaching {
    /// Reads a kitchen and one of its pieces, given what is advised; none while the piece is held or has fallen.
    pub fn of(kitchen: &Kitchen, piece: &Piece, advice: &[Advice]) -> Option<Self> {
        let (now, raw) = (piece.state.fat.iter().sum::<f64>(), piece.model.initial_fat().iter().sum::<f64>());
        let about_food = |one: &&Advice| one.hob_w().is_none();
        let readings = Readings {
            situation: Situation::of(kitchen, piece),
            oiled: kitchen.pan_state().oil_mass() > 0.0,
            renders: raw > FATTY * piece.model.raw_mass() && now < (1.0 - RENDERED) * raw,
            curls: piece.model.mesh().swept().is_some_and(|mesh| !mesh.is_upright()),
            advice: advice.iter().find(about_food).copied(),
        };
        readings.coaching()
    }
}

impl Readings {
    fn coaching(&self) -> Option<Coaching> {
        let with = |(happening, cue)| Coaching { happening, cue };
        match self.situation.place {
            Place::Waiting => Some(with(self.before())),
            Place::Pan(_) => Some(with(self.in_pan())),
            Place::Rest(_) => Some(with(self.resting())),
            _ => None,
        }
    }

    fn smokes(&self) -> bool {
        self.situation.smoke_mg_s >= SMOKE_SEEN_MG_S
    }

    fn before(&self) -> (Happening, Option<Cue>) {
        let Situation { pan_c, hob_w, heated_by: by, .. } = self.situation;
        let hot = if self.oiled { Cue::OilShimmers } else { Cue::DropDances };
        match () {
            () if self.smokes() => (Happening::OilSmokes, Some(Cue::SmokeStops)),
            () if pan_c >= WARM_ENOUGH_C => (Happening::PanIsHot { pan_c }, Some(Cue::LivelySizzle)),
            () if hob_w > 0.0 => (Happening::PanHeats { pan_c, by }, (pan_c < HOT_C).then_some(hot)),
            () => (Happening::PanIsCold, None),
        }
    }

    fn in_pan(&self) -> (Happening, Option<Cue>) {
        let Situation { underside_c, core_c, browning: [below, _], since_flip_s, .. } = self.situation;
        let flipped = since_flip_s.is_some();
        if self.smokes() {
            return (Happening::OilSmokes, Some(Cue::SmokeStops));
        }
        if underside_c < BOILS_FROM_C {
            return (Happening::FaceWarms { underside_c }, Some(self.while_wet()));
        }
        if underside_c < WET_BELOW_C {
            return (Happening::WaterBoilsOff { underside_c }, Some(self.while_wet()));
        }
        if let Some(Advice::NotReady { share_pct, .. } | Advice::Ready { share_pct }) = self.advice {
            return (Happening::Softens { share_pct }, Some(self.of_the_inside()));
        }
        match () {
            () if underside_c < BROWNS_FROM_C && below < CRUST_SEEN => {
                (Happening::FaceDries { underside_c }, Some(Cue::EdgeBrowns))
            }
            () if below >= BROWN_ENOUGH && !flipped => (Happening::CrustDarkens, Some(Cue::EdgeBrowns)),
            () if flipped && below >= CRUST_SEEN => (Happening::CoreLags { core_c }, Some(self.of_the_inside())),
            () if self.renders && below >= CRUST_SEEN => (Happening::FatRenders, Some(self.of_the_inside())),
            () => (Happening::Browns { underside_c }, Some(self.while_browning())),
        }
    }

    fn while_wet(&self) -> Cue {
        if self.curls { Cue::CurlsOpaque } else { Cue::SizzleFades }
    }

    fn while_browning(&self) -> Cue {
        if self.situation.since_flip_s.is_some() { self.of_the_inside() } else { Cue::EdgeBrowns }
    }

    /// The cue of the inside: the further it is, the nearer to the goal.
    fn of_the_inside(&self) -> Cue {
        match self.advice {
            _ if self.curls => Cue::CurlsOpaque,
            Some(Advice::NotReady { share_pct, until_pct }) if share_pct < NEAR_SHARE * until_pct => Cue::EdgeBrowns,
            Some(Advice::NotReady { .. } | Advice::Ready { .. }) => Cue::KnifeSlides,
            Some(Advice::TakeOut { .. }) => Cue::Firmer,
            Some(Advice::WouldPeak { peak_c, .. }) if self.situation.core_c > peak_c - NEAR_K => Cue::Firmer,
            _ if self.situation.core_c >= JUICE_FROM_C => Cue::JuiceBeads,
            _ => Cue::SteamAtSides,
        }
    }

    fn resting(&self) -> (Happening, Option<Cue>) {
        let is_over = matches!(self.advice, Some(Advice::Rested { .. } | Advice::Resting { warms: false, .. }));
        let core_c = self.situation.core_c;
        if is_over { (Happening::Rested, None) } else { (Happening::CarriesOver { core_c }, Some(Cue::WarmOnTop)) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::RestOn;

    const WAITING: Readings =
        Readings { situation: Situation::RAW, oiled: false, renders: false, curls: false, advice: None };

    fn at(change: impl Fn(&mut Readings)) -> (Happening, Option<Cue>) {
        let mut readings = WAITING;
        change(&mut readings);
        let coaching = readings.coaching().expect("something is said");
        (coaching.happening, coaching.cue)
    }

    fn in_pan(change: impl Fn(&mut Readings)) -> (Happening, Option<Cue>) {
        at(|r| {
            (r.situation.place, r.situation.pan_c, r.situation.hob_w) = (Place::Pan([0.0; 2]), 200.0, 1100.0);
            change(r);
        })
    }

    #[test]
    fn a_pan_is_hot_by_its_oil_or_by_a_drop_that_dances() {
        assert_eq!(at(|_| {}), (Happening::PanIsCold, None));
        let heats = |oiled| at(|r| (r.situation.hob_w, r.situation.pan_c, r.oiled) = (1100.0, 120.0, oiled));
        assert_eq!(heats(false), (Happening::PanHeats { pan_c: 120.0, by: HeaterKind::Coil }, Some(Cue::DropDances)));
        assert_eq!(heats(true).1, Some(Cue::OilShimmers));
        assert_eq!(at(|r| r.situation.pan_c = 190.0).1, Some(Cue::LivelySizzle));
        assert_eq!(at(|r| r.situation.smoke_mg_s = 2.0), (Happening::OilSmokes, Some(Cue::SmokeStops)));
    }

    #[test]
    fn a_face_is_wet_then_dries_then_browns_and_each_has_its_cue() {
        let face = |c, brown| in_pan(|r| (r.situation.underside_c, r.situation.browning[0]) = (c, brown));
        assert_eq!(face(30.0, 0.0).0, Happening::FaceWarms { underside_c: 30.0 });
        assert_eq!(face(99.0, 0.0), (Happening::WaterBoilsOff { underside_c: 99.0 }, Some(Cue::SizzleFades)));
        assert_eq!(face(120.0, 0.0), (Happening::FaceDries { underside_c: 120.0 }, Some(Cue::EdgeBrowns)));
        assert_eq!(face(160.0, 0.3).0, Happening::Browns { underside_c: 160.0 });
        assert_eq!(face(180.0, 0.95).0, Happening::CrustDarkens);
    }

    #[test]
    fn the_inside_is_told_by_steam_then_by_juice_then_by_touch() {
        let core = |c, advice| {
            in_pan(|r| {
                (r.situation.since_flip_s, r.situation.underside_c, r.situation.browning) =
                    (Some(60.0), 160.0, [0.6, 0.8]);
                (r.situation.core_c, r.advice) = (c, Some(advice));
            })
        };
        let would = |peak_c| Advice::WouldPeak { peak_c, wet: false };
        assert_eq!(core(30.0, would(50.0)), (Happening::CoreLags { core_c: 30.0 }, Some(Cue::SteamAtSides)));
        assert_eq!(core(49.0, would(58.0)).1, Some(Cue::JuiceBeads));
        assert_eq!(core(56.0, would(60.0)).1, Some(Cue::Firmer));
        assert_eq!(core(45.0, Advice::TakeOut { peak_c: 62.0 }).1, Some(Cue::Firmer));
        let fat = in_pan(|r| (r.situation.underside_c, r.situation.browning[0], r.renders) = (160.0, 0.6, true));
        assert_eq!(fat.0, Happening::FatRenders);
    }

    #[test]
    fn vegetables_soften_shrimps_curl_and_what_rests_warms_on() {
        let soft = |share_pct| {
            in_pan(|r| {
                r.situation.underside_c = 120.0;
                r.advice = Some(Advice::NotReady { share_pct, until_pct: 50.0 });
            })
        };
        assert_eq!(soft(40.0), (Happening::Softens { share_pct: 40.0 }, Some(Cue::KnifeSlides)));
        assert_eq!(in_pan(|r| (r.situation.underside_c, r.curls) = (95.0, true)).1, Some(Cue::CurlsOpaque));
        let rests = |advice| at(|r| (r.situation.place, r.advice) = (Place::Rest(RestOn::Board), Some(advice)));
        assert_eq!(rests(Advice::Resting { peak_c: 60.0, warms: true }).1, Some(Cue::WarmOnTop));
        assert_eq!(rests(Advice::Rested { peak_c: 60.0 }), (Happening::Rested, None));
        assert_eq!(
            Readings { situation: Situation { place: Place::Held, ..WAITING.situation }, ..WAITING }.coaching(),
            None
        );
    }

    #[test]
    fn every_cue_is_for_a_sense() {
        assert_eq!(
            [Cue::SizzleFades, Cue::EdgeBrowns, Cue::Firmer].map(Cue::sense),
            [Sense::Listen, Sense::Look, Sense::Feel]
        );
    }
}

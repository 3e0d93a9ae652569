//! What a cook gave, as a few plain numbers.

use saute_kitchen::data::goals::Counted;
use saute_kitchen::food::change::doneness::Measure;
use saute_kitchen::{Kitchen, Piece, celsius};
use serde::{Deserialize, Serialize};

use crate::goal::Goal;

/// What a cook gave: means over its pieces.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Serialize)]
pub struct Outcome {
    /// Highest temperature of the core, the rest included [°C].
    pub core_peak_c: f64,
    /// What the scale of the goal measures at the core [°C or %].
    pub at_core: f64,
    /// Share of the section in the class of the goal, by the highest temperature reached or by the share of the change; for a
    /// goal of the faces, browned share of them, on ridges of the bars [%].
    pub target_share_pct: f64,
    /// Share of the section that is beyond the class of the goal: the grey band [%].
    pub beyond_pct: f64,
    /// Browned share of the two faces, on ridges of the bars [%].
    pub crust_pct: f64,
    /// Browned share of the face with less of it [%].
    pub least_crust_pct: f64,
    /// Charred share of the two faces [%].
    pub charred_pct: f64,
    /// Mass that was lost [%].
    pub lost_pct: f64,
    /// Highest temperature of any place of the pan's floor [°C].
    pub hottest_c: f64,
    /// True if the oil passed its flash point or burned.
    pub fire_hazard: bool,
}

impl Outcome {
    /// Reads the outcome of a kitchen, given the masses of its pieces at the start [kg].
    pub fn read(kitchen: &Kitchen, masses_at_start: &[f64], goal: &Goal) -> Self {
        let pieces: Vec<&Piece> = kitchen.pieces().iter().collect();
        Self::of(kitchen, &pieces, masses_at_start, goal)
    }

    /// As [`Self::read`], of some of the kitchen's pieces.
    pub fn of(kitchen: &Kitchen, pieces: &[&Piece], masses_at_start: &[f64], goal: &Goal) -> Self {
        let mean = |value: &dyn Fn(&Piece) -> f64| pieces.iter().copied().map(value).sum::<f64>() / pieces.len() as f64;
        let lost = pieces.iter().zip(masses_at_start).map(|(piece, start)| 100.0 * (1.0 - piece.mass() / start));
        let face = |piece: &Piece, below: bool| {
            piece.model.face_reading(&piece.state, piece.up().map(|u| if below { u } else { -u }))
        };
        let crust = |piece: &Piece| [true, false].map(|below| face(piece, below).crust_pct);
        let charred = |piece: &Piece| [true, false].map(|below| face(piece, below).charred_pct);
        let both = |piece: &Piece| crust(piece).iter().sum::<f64>() / 2.0;
        Self {
            core_peak_c: mean(&|piece| celsius(piece.core_peak.0)),
            at_core: at_core(pieces.iter().copied(), goal, |piece| piece.core_peak.0),
            target_share_pct: mean(&|piece| match goal.counts {
                Counted::Section => shares(piece, goal)[goal.class],
                Counted::Faces => both(piece),
            }),
            beyond_pct: mean(&|piece| shares(piece, goal).iter().skip(goal.class + 1).sum()),
            crust_pct: mean(&both),
            least_crust_pct: mean(&|piece| crust(piece).iter().copied().fold(100.0, f64::min)),
            charred_pct: mean(&|piece| charred(piece).iter().sum::<f64>() / 2.0),
            lost_pct: lost.sum::<f64>() / pieces.len() as f64,
            hottest_c: celsius(floor_peaks(kitchen).fold(0.0, f64::max)),
            fire_hazard: kitchen.events().tallies().any(|tally| tally.kind.is_fire_hazard()),
        }
    }
}

/// Highest temperature so far of each node of the pan's floor [K].
fn floor_peaks(kitchen: &Kitchen) -> impl Iterator<Item = f64> {
    kitchen.pan_state().peak.iter().copied().take(kitchen.pan_model().floor_nodes)
}

/// Shares of the classes in the section of a piece, the same as those of a summary [%].
fn shares(piece: &Piece, goal: &Goal) -> [f64; 5] {
    piece.model.cut_shares(&piece.state, &piece.model.cut_across(0.0), &goal.scale).0
}

/// Mean over the pieces of what the goal's scale measures at the core, given the temperature that counts [°C or %].
pub(crate) fn at_core<'a>(
    pieces: impl ExactSizeIterator<Item = &'a Piece>,
    goal: &Goal,
    temperature: impl Fn(&Piece) -> f64,
) -> f64 {
    let value = |piece: &Piece| match goal.scale.measure() {
        Measure::Peak => celsius(temperature(piece)),
        Measure::Share => match piece.model.measured(&piece.state, &goal.scale) {
            [] => 0.0,
            field => 100.0 * piece.model.core_share(field, &goal.scale),
        },
    };
    let count = pieces.len();
    pieces.map(value).sum::<f64>() / count as f64
}

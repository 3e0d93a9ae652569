//! What a cook sees, hears and feels at a step, derived from the numbers of the planned cook.

use std::collections::BTreeMap;

use saute_kitchen::Library;
use saute_kitchen::advice::SMOKE_SEEN_MG_S;

use crate::schedule::{Cue, Deed, Plan, Step};

/// What there is to see, hear and feel at a step.
#[derive(Clone, Debug, PartialEq)]
pub enum Sense {
    /// The pan when the food goes in.
    Pan {
        /// Mean temperature of its floor [°C].
        pan_c: f64,
        /// What a drop of water does on it.
        drop: Drop,
        /// True if nobody sees its oil smoke: smoke then means that it is too hot.
        is_smokeless: bool,
    },
    /// The face on the pan, seen when its edge is lifted.
    Face {
        /// Browned share [%].
        browned_pct: f64,
        /// Its colour.
        colour: Colour,
        /// What is heard.
        hiss: Hiss,
        /// Mean temperature of the core [°C].
        core_c: f64,
    },
    /// The food when it is done.
    Done {
        /// Mean temperature of the core [°C].
        core_c: f64,
        /// What the core rises by while it rests [K].
        rise_k: f64,
        /// How it feels under a finger, by the code of the language; empty where its file has no words for it.
        feel: BTreeMap<String, String>,
    },
    /// The food when it has rested.
    Rested {
        /// Highest temperature of the core [°C].
        peak_c: f64,
    },
}

/// What a drop of water does on a pan.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Drop {
    /// It lies and hisses.
    Lies,
    /// It bursts at once.
    Bursts,
    /// It runs about in beads.
    Runs,
}

/// Colour of a face that was fried.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Colour {
    /// Pale.
    Pale,
    /// Brown in patches.
    Patches,
    /// Brown over most of it.
    Most,
    /// Brown all over.
    All,
}

/// Sound of the steam.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Hiss {
    /// A quiet sizzle.
    Quiet,
    /// A steady sizzle.
    Steady,
    /// A loud hiss.
    Loud,
}

impl Plan {
    /// Returns what there is to see, hear and feel at a step; none where only a knob is turned.
    pub fn sense(&self, step: &Step, library: &Library) -> Option<Sense> {
        let peak_c = self.promised.core_peak_c;
        let cue = self.cue(step);
        match step.deed {
            Deed::Power(_) => None,
            Deed::Put => cue.map(pan),
            Deed::Flip(_) => cue.map(face),
            Deed::Pull => cue.map(|cue| Sense::Done {
                core_c: cue.core_c,
                rise_k: (peak_c - cue.core_c).max(0.0),
                feel: library.foods.get(&self.order.food).map(|food| food.feel_at(peak_c)).unwrap_or_default(),
            }),
            Deed::Serve => Some(Sense::Rested { peak_c }),
        }
    }
}

fn pan(cue: &Cue) -> Sense {
    let drop = match cue.pan_c {
        c if c < 150.0 => Drop::Lies,
        c if c < 190.0 => Drop::Bursts,
        _ => Drop::Runs,
    };
    Sense::Pan { pan_c: cue.pan_c, drop, is_smokeless: cue.smoke_mg_s < SMOKE_SEEN_MG_S }
}

fn face(cue: &Cue) -> Sense {
    let colour = match cue.browned_pct {
        pct if pct < 10.0 => Colour::Pale,
        pct if pct < 50.0 => Colour::Patches,
        pct if pct < 90.0 => Colour::Most,
        _ => Colour::All,
    };
    // Chosen: a hand's breadth of wet meat on a hot pan gives off about 0.1 g/s.
    let hiss = match cue.steam_g_s {
        s if s < 0.03 => Hiss::Quiet,
        s if s < 0.1 => Hiss::Steady,
        _ => Hiss::Loud,
    };
    Sense::Face { browned_pct: cue.browned_pct, colour, hiss, core_c: cue.core_c }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn smoke_means_too_hot_only_where_the_planned_pan_shows_none() {
        let cue =
            |smoke_mg_s| Cue { at_s: 66, pan_c: 200.0, smoke_mg_s, core_c: 5.0, browned_pct: 0.0, steam_g_s: 0.0 };
        // The ring over the coil is above the smoke point of the oil there, and nobody sees its smoke.
        let warns = |smoke_mg_s| matches!(pan(&cue(smoke_mg_s)), Sense::Pan { is_smokeless: true, .. });
        assert!(warns(0.0) && warns(0.1));
        assert!(!warns(SMOKE_SEEN_MG_S));
    }
}

//! A rest on a clone of the kitchen.

use saute_kitchen::{Kitchen, Piece};

use crate::goal::{Goal, Outcome, at_core};
use crate::schedule::candidate::job::Cue;
use crate::schedule::candidate::stove::Stove;

/// Shortest and longest rest [s] (chosen: a minute lets the juices settle; the core of a thick steak peaks within ten).
const REST_S: [u32; 2] = [60, 600];
/// A rest ends at a multiple of this [s] (chosen: nobody rests meat by the second).
const REST_STEP_S: u32 = 10;
/// Time for which every core has fallen when a rest ends [s] (chosen).
const FALLEN_S: f64 = 15.0;
/// A food that was pulled and rested.
#[derive(Clone, Debug)]
pub(crate) struct Rested {
    /// When it was pulled [s].
    pub(crate) pull_s: u32,
    /// How long it rested [s].
    pub(crate) rest_s: u32,
    /// What it gave.
    pub(crate) outcome: Outcome,
    /// Rise of the core during the rest [K or points of %].
    pub(crate) rise: f64,
    /// What there was to see when it was pulled.
    pub(crate) pull: Option<Cue>,
    /// Work that it took [-].
    pub(crate) work: u64,
}

/// Foods that rest on a clone of their kitchen.
#[derive(Clone, Debug)]
pub(crate) struct Resting {
    stove: Stove,
    pull_s: u32,
    /// Length of the rest [s]; until the cores have peaked unless given.
    rest_s: Option<u32>,
    /// Core before the rest [°C or %].
    before: f64,
    /// Time since the pull [s].
    elapsed_s: u32,
    work: u64,
}

impl Resting {
    /// Pulls the foods of a stove now, to rest them for a time [s], or until their cores have peaked.
    pub(crate) fn begin(mut stove: Stove, pull_s: u32, goal: &Goal, rest_s: Option<u32>) -> Self {
        let before = core_now(stove.kitchen(), goal);
        stove.pull();
        Self { stove, pull_s, rest_s, before, elapsed_s: 0, work: 0 }
    }

    /// Rests for a second; returns false if the rest is over.
    pub(crate) fn second(&mut self) -> bool {
        let kitchen = self.stove.kitchen();
        let lasts = self.rest_s.map_or_else(|| goes_on(kitchen, self.elapsed_s), |end| self.elapsed_s < end);
        if lasts {
            self.work += self.stove.rest_second();
            self.elapsed_s += 1;
        }
        lasts
    }

    /// What the rest gave, with the masses at the start [kg].
    pub(crate) fn rested(&self, masses: &[f64], goal: &Goal) -> Rested {
        let outcome = Outcome::read(self.stove.kitchen(), masses, goal);
        let (rest_s, rise) = (self.elapsed_s, outcome.at_core - self.before);
        Rested { pull_s: self.pull_s, rest_s, outcome, rise, pull: None, work: self.work }
    }
}

/// Returns true while a core may still rise.
fn goes_on(kitchen: &Kitchen, elapsed_s: u32) -> bool {
    let latest = kitchen.pieces().iter().map(|p| p.core_peak.1).fold(0.0, f64::max);
    let is_over = elapsed_s.is_multiple_of(REST_STEP_S) && kitchen.time_s() - latest >= FALLEN_S;
    elapsed_s < REST_S[0] || (elapsed_s < REST_S[1] && !is_over)
}

/// Mean of what the goal's scale measures at the core now [°C or %].
pub(crate) fn core_now(kitchen: &Kitchen, goal: &Goal) -> f64 {
    at_core(kitchen.pieces().iter(), goal, Piece::core)
}

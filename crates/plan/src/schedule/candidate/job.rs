//! A job: a whole candidate to be cooked, and what came of it.

use saute_kitchen::Library;
use saute_kitchen::kitchen::SetupError;
use saute_schema::InputError;
use serde::{Deserialize, Serialize};

use crate::goal::{Outcome, Score};
use crate::schedule::candidate::cooking::Cooking;
use crate::schedule::{Order, Schedule};

/// How a job finds the time to pull the food.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Pull {
    /// At the time of its schedule.
    AtItsTime,
    /// When the core, after its rest, comes to the aim of the goal. The rests are cooked on clones of the kitchen.
    ToAim {
        /// Rise of the core during the rest that is expected [K or points of %]; rather too much than too little.
        rise: f64,
        /// Largest miss of the aim after which no further time is tried [K or points of %].
        within: f64,
        /// Largest number of rests that are cooked [-].
        most_rests: u32,
    },
}

/// Meshes on which a candidate is cooked.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Mesh {
    /// Those of the kitchen, with this spacing relative to the default [-].
    Spaced(f64),
    /// Those of forecasts, once the food is in the pan. Bodies are still: for one slice.
    Reduced,
}

/// A whole candidate to be cooked.
#[derive(Clone, Debug, PartialEq)]
pub struct Job {
    /// What is cooked.
    pub order: Order,
    /// The times; with [`Pull::ToAim`] its last one is the latest time to pull.
    pub schedule: Schedule,
    /// How the time to pull is found.
    pub pull: Pull,
    /// Meshes of the foods.
    pub mesh: Mesh,
}

/// What a cook looks and feels like at one of its steps.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Serialize)]
pub struct Cue {
    /// Time since the start [s].
    pub at_s: u32,
    /// Mean temperature of the pan's floor [°C].
    pub pan_c: f64,
    /// Smoke from the pan's oil [mg/s].
    pub smoke_mg_s: f64,
    /// Mean temperature of the core [°C].
    pub core_c: f64,
    /// Browned share of the face on the pan, on ridges of the bars [%].
    pub browned_pct: f64,
    /// Steam that leaves the food: the strength of the hiss [g/s].
    pub steam_g_s: f64,
}

/// What came of a job.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct JobResult {
    /// The schedule, with the time at which the food was pulled and the length of its rest.
    pub schedule: Schedule,
    /// What the cook gave.
    pub outcome: Outcome,
    /// Its score.
    pub score: Score,
    /// Rise of the core during the rest [K or points of %].
    pub rise: f64,
    /// One for putting in, each flip, and pulling.
    pub cues: Vec<Cue>,
    /// Work that it took: ticks times nodes, with a share for the pan [-].
    pub work: u64,
}

/// Why a job cannot be done.
#[derive(Clone, Debug, thiserror::Error)]
pub enum JobError {
    /// The hob has no power.
    #[error("the order has no power of the hob")]
    NoPower,
    /// Its recipe cannot be used.
    #[error(transparent)]
    Input(#[from] InputError),
    /// Its kitchen cannot be built.
    #[error(transparent)]
    Setup(#[from] SetupError),
}

impl Job {
    /// Cooks the candidate.
    ///
    /// # Errors
    ///
    /// If the order or the schedule makes no recipe.
    pub fn run(&self, library: &Library) -> Result<JobResult, JobError> {
        let mut cooking = Cooking::begin(self.clone(), library)?;
        loop {
            if let Some(result) = cooking.second()? {
                return Ok(result);
            }
        }
    }
}

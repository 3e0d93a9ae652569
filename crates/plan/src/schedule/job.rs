//! A job: a whole candidate to be cooked, and what came of it.

use saute_kitchen::kitchen::SetupError;
use saute_kitchen::{InputError, Kitchen, Library, TICK_S, celsius};
use saute_recipe::Cook;
use serde::{Deserialize, Serialize};

use crate::goal::{Outcome, Score};
use crate::schedule::fork::{self, Rested};
use crate::schedule::{Order, Schedule};

/// Ticks in a second [-].
pub(crate) const TICKS_PER_S: u32 = (1.0 / TICK_S + 0.5) as u32;

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

/// A whole candidate to be cooked.
#[derive(Clone, Debug, PartialEq)]
pub struct Job {
    /// What is cooked.
    pub order: Order,
    /// The times; with [`Pull::ToAim`] its last one is the latest time to pull.
    pub schedule: Schedule,
    /// How the time to pull is found.
    pub pull: Pull,
    /// Mesh spacing relative to the default [-].
    pub coarseness: f64,
}

/// What a cook looks and feels like at one of its steps.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Serialize)]
pub struct Cue {
    /// Time since the start [s].
    pub at_s: u32,
    /// Mean temperature of the pan's floor [°C].
    pub pan_c: f64,
    /// Mean temperature of the core [°C].
    pub core_c: f64,
    /// Browned share of the face on the pan [%].
    pub browned_pct: f64,
    /// Steam that leaves the food: the strength of the hiss [g/s].
    pub steam_g_s: f64,
}

/// What came of a job.
#[derive(Clone, Debug, PartialEq)]
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
        let schedule = self.schedule.pulled_at(self.schedule.pull_s, self.schedule.rest_s);
        let mut recipe = schedule.recipe(&self.order, library)?;
        recipe.foods.iter_mut().for_each(|food| food.coarseness = self.coarseness);
        let mut trunk = Trunk::new(Cook::new(recipe, library)?, self);
        match self.pull {
            Pull::AtItsTime => trunk.to(self.schedule.pull_s)?,
            Pull::ToAim { rise, within, most_rests } => return trunk.until_aim([rise, within], most_rests),
        }
        let rested = trunk.rest(Some(self.schedule.rest_s));
        Ok(trunk.result(rested))
    }
}

/// The cook up to the pull.
struct Trunk<'a> {
    job: &'a Job,
    cook: Cook,
    masses: Vec<f64>,
    cues: Vec<Cue>,
    at_s: u32,
    work: u64,
}

impl<'a> Trunk<'a> {
    fn new(cook: Cook, job: &'a Job) -> Self {
        let masses = cook.kitchen.pieces().iter().map(saute_kitchen::Piece::mass).collect();
        Self { job, cook, masses, cues: Vec::new(), at_s: 0, work: 0 }
    }

    /// Cooks to a time [s].
    fn to(&mut self, until_s: u32) -> Result<(), InputError> {
        while self.at_s < until_s {
            self.second()?;
        }
        Ok(())
    }

    /// Cooks on for a second; before it, notes what there is to see where a step comes.
    fn second(&mut self) -> Result<(), InputError> {
        let Schedule { put_s, flips_s, .. } = &self.job.schedule;
        if self.at_s == *put_s || flips_s.contains(&self.at_s) {
            self.cues.push(self.cue());
        }
        for _ in 0..TICKS_PER_S {
            self.cook.advance()?;
        }
        self.work += fork::work_of_second(&self.cook.kitchen);
        self.at_s += 1;
        Ok(())
    }

    fn cue(&self) -> Cue {
        let kitchen: &Kitchen = &self.cook.kitchen;
        let pieces = kitchen.pieces();
        let mean =
            |value: &dyn Fn(&saute_kitchen::Piece) -> f64| pieces.iter().map(value).sum::<f64>() / pieces.len() as f64;
        Cue {
            at_s: self.at_s,
            pan_c: celsius(kitchen.pan_temperature()),
            core_c: mean(&|p| celsius(p.core())),
            browned_pct: mean(&|p| p.model.face_reading(&p.state, p.up()).browned_pct),
            steam_g_s: 1e3 * pieces.iter().map(|p| p.vapour_flow).sum::<f64>(),
        }
    }

    /// Cooks until the core comes to the aim after its rest, and the rests.
    fn until_aim(mut self, [rise, within]: [f64; 2], most_rests: u32) -> Result<JobResult, JobError> {
        let goal = &self.job.order.goal;
        let missing = |rested: &Rested| goal.aim - rested.outcome.at_core;
        let (mut next, mut rests, mut best) = (goal.aim - rise, 0, None::<Rested>);
        self.to(self.job.schedule.put_s + SETTLED_S)?;
        loop {
            self.second()?;
            let is_last = self.at_s >= self.job.schedule.pull_s;
            let core = fork::core_now(&self.cook.kitchen, goal);
            if core < next && !is_last {
                continue;
            }
            let rested = self.rest(None);
            rests += 1;
            next = core + NEXT_SHARE * missing(&rested);
            let is_over = is_last || rests >= most_rests || missing(&rested) <= within;
            let closest = best.take().filter(|best| missing(best).abs() <= missing(&rested).abs()).unwrap_or(rested);
            if is_over {
                return Ok(self.result(closest));
            }
            best = Some(closest);
        }
    }

    /// Rests the food on a clone of the kitchen, for a time or until nothing more happens to its core.
    fn rest(&mut self, rest_s: Option<u32>) -> Rested {
        let rested = fork::rest(&self.cook.kitchen, self.at_s, &self.masses, &self.job.order.goal, rest_s);
        self.work += rested.work;
        let pull = self.cue();
        Rested { pull: Some(pull), ..rested }
    }

    fn result(self, rested: Rested) -> JobResult {
        let schedule = self.job.schedule.pulled_at(rested.pull_s, rested.rest_s);
        let pull = rested.pull.into_iter();
        let cues = self.cues.into_iter().filter(|cue| cue.at_s < rested.pull_s).chain(pull).collect();
        JobResult {
            score: Score::of(&rested.outcome, schedule.flips_s.len(), &self.job.order.goal),
            outcome: rested.outcome,
            rise: rested.rise,
            work: self.work,
            schedule,
            cues,
        }
    }
}

/// Time from putting in to the first look at the core [s] (chosen: a piece that has just been laid down).
const SETTLED_S: u32 = 5;
/// Share of what is missing at the aim after a rest that the next one starts with [-] (chosen: the core rises a little more in the
/// rest of a hotter piece).
const NEXT_SHARE: f64 = 0.9;

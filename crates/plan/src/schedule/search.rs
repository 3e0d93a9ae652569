//! A search for a plan that is carried out job by job in one place, and the answer as plain data.

use std::sync::Arc;

use saute_kitchen::Library;
use serde::{Deserialize, Serialize};

use crate::goal::{Outcome, Score};
use crate::schedule::asked::{Asked, AskedError};
use crate::schedule::{Cooking, Cue, Job, JobError, JobResult, Order, Plan, Planner, Schedule, Sensitivity, Stage};

/// A plan without its order, as data that travels.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct PlanData {
    schedule: Schedule,
    promised: Outcome,
    score: Score,
    cues: Vec<Cue>,
    sensitivity: Vec<Sensitivity>,
    candidates: usize,
    is_stopped: bool,
    is_rough: bool,
}

impl From<&Plan> for PlanData {
    fn from(plan: &Plan) -> Self {
        let Plan { schedule, promised, score, cues, sensitivity, candidates, is_stopped, is_rough, .. } = plan.clone();
        Self { schedule, promised, score, cues, sensitivity, candidates, is_stopped, is_rough }
    }
}

impl PlanData {
    /// Returns the plan with the order that it answers.
    pub fn plan(self, order: Order) -> Plan {
        let Self { schedule, promised, score, cues, sensitivity, candidates, is_stopped, is_rough } = self;
        Plan { order, schedule, promised, score, cues, sensitivity, candidates, is_stopped, is_rough }
    }
}

/// How far a search has come.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Serialize)]
pub struct SearchProgress {
    /// Number of candidates that were cooked [-].
    pub candidates: usize,
    /// Share of the work that is done; an estimate that does not fall [-].
    pub share: f64,
    /// What is done now.
    pub stage: Stage,
}

/// A job of the present round.
#[derive(Clone, Debug)]
enum Slot {
    Open(Box<Job>),
    Begun(Box<Cooking>),
    Done(Box<JobResult>),
}

/// A search that is carried out second by second of its cooks.
#[derive(Clone, Debug)]
pub struct Search {
    planner: Planner,
    library: Arc<Library>,
    round: Vec<Slot>,
    done: usize,
    /// Jobs that it has about [-].
    usual_jobs: f64,
    share: f64,
}

/// Jobs that a search has about, and one for a plain plan [-] (measured: 30 to 55 of steaks, patties and vegetables; plain ones 30 to 40).
const USUAL_JOBS: f64 = 42.0;
const PLAIN_JOBS: f64 = 34.0;
/// Share of the work before which no estimate ends [-] (chosen: the last job is the longest).
const MOST_SHARE: f64 = 0.97;

impl Search {
    /// Begins a search.
    ///
    /// # Errors
    ///
    /// If the request makes no order.
    pub fn new(asked: &Asked, library: Arc<Library>) -> Result<Self, AskedError> {
        let planner = Planner::new(asked.order(&library)?, Arc::clone(&library))?;
        let usual_jobs = if asked.plain { PLAIN_JOBS } else { USUAL_JOBS };
        Ok(Self { planner, library, round: Vec::new(), done: 0, usual_jobs, share: 0.0 })
    }

    /// Goes on with the first jobs of the present round that are not done, at most so many at once. `cook` lets some or all seconds
    /// of theirs pass ([`Cooking::second`]) and returns the results of those that are over, in their order. How it does that does
    /// not change the plan.
    ///
    /// # Errors
    ///
    /// If a job makes no recipe.
    pub fn go_on(
        &mut self,
        at_once: usize,
        cook: impl FnOnce(&mut [&mut Cooking]) -> Result<Vec<Option<JobResult>>, JobError>,
    ) -> Result<(), AskedError> {
        self.fill_round();
        let is_open = |slot: &&mut Slot| !matches!(slot, Slot::Done(_));
        let mut begun: Vec<&mut Slot> = self.round.iter_mut().filter(is_open).take(at_once).collect();
        for slot in &mut begun {
            if let Slot::Open(job) = &**slot {
                **slot = Slot::Begun(Box::new(Cooking::begin(Job::clone(job), &self.library)?));
            }
        }
        let mut cookings: Vec<&mut Cooking> = begun
            .iter_mut()
            .filter_map(|slot| if let Slot::Begun(cooking) = &mut **slot { Some(&mut **cooking) } else { None })
            .collect();
        let results = cook(&mut cookings)?;
        for (slot, result) in begun.into_iter().zip(results) {
            if let Some(result) = result {
                *slot = Slot::Done(Box::new(result));
                self.done += 1;
            }
        }
        self.end_round();
        self.share = self.share.max((self.done as f64 / self.usual_jobs).min(MOST_SHARE));
        Ok(())
    }

    /// Begins the next round; one of the search may have no job.
    fn fill_round(&mut self) {
        while self.round.is_empty() && self.planner.plan().is_none() {
            self.round = self.planner.next_jobs().into_iter().map(|job| Slot::Open(Box::new(job))).collect();
            if self.round.is_empty() {
                self.planner.take(Vec::new());
            }
        }
    }

    fn end_round(&mut self) {
        if !self.round.iter().all(|slot| matches!(slot, Slot::Done(_))) {
            return;
        }
        let result = |slot| if let Slot::Done(result) = slot { Some(*result) } else { None };
        let results = std::mem::take(&mut self.round).into_iter().filter_map(result).collect();
        self.planner.take(results);
    }

    /// Returns how far the search has come.
    pub fn progress(&self) -> SearchProgress {
        SearchProgress { candidates: self.done, share: self.share, stage: self.planner.stage() }
    }

    /// Returns the plan once the search is over.
    pub fn plan(&self) -> Option<Plan> {
        self.planner.plan()
    }

    /// Returns the best plan so far, for a search that is stopped.
    pub fn so_far(&self) -> Option<Plan> {
        self.planner.so_far()
    }
}

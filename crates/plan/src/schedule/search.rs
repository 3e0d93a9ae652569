//! A search for a plan that is carried out job by job in one place, and the answer as plain data.

use std::sync::Arc;

use saute_kitchen::Library;
use serde::{Deserialize, Serialize};

use crate::goal::{Outcome, Score};
use crate::round::{End, Round, Shared};
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

/// A search that is carried out second by second of its cooks.
#[derive(Clone, Debug)]
pub struct Search {
    planner: Planner,
    library: Arc<Library>,
    round: Round<Job, Cooking, JobResult>,
    /// Jobs of the rounds that have ended [-].
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
    /// Begins a search; one of two who share it begins its rounds at the back.
    ///
    /// # Errors
    ///
    /// If the request makes no order.
    pub fn new(asked: &Asked, library: Arc<Library>, end: End) -> Result<Self, AskedError> {
        let planner = Planner::new(asked.order(&library)?, Arc::clone(&library))?;
        let usual_jobs = if asked.plain { PLAIN_JOBS } else { USUAL_JOBS };
        Ok(Self { planner, library, round: Round::new(end), done: 0, usual_jobs, share: 0.0 })
    }

    /// Goes on with the next jobs of the present round that are not done, at most so many at once. `cook` lets some or all seconds
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
        let begin = |job: &Job| Cooking::begin(job.clone(), &self.library);
        self.round.go_on(at_once, begin, cook)?;
        self.end_round();
        Ok(())
    }

    /// Takes the own results since the last call, for a twin that searches for the same.
    pub fn shares(&mut self) -> Vec<Shared<JobResult>> {
        self.round.shares()
    }

    /// Takes a result of a twin.
    pub fn take(&mut self, shared: Shared<JobResult>) {
        self.fill_round();
        self.round.take(shared);
        self.end_round();
    }

    /// Begins the next round; one of the search may have no job.
    fn fill_round(&mut self) {
        while self.round.is_empty() && self.planner.plan().is_none() {
            self.round.begin(self.planner.next_jobs());
            if self.round.is_empty() {
                self.planner.take(Vec::new());
            }
        }
    }

    fn end_round(&mut self) {
        if let Some(results) = self.round.end() {
            self.done += results.len();
            self.planner.take(results);
        }
        self.share = self.share.max((self.cooked() as f64 / self.usual_jobs).min(MOST_SHARE));
    }

    /// Number of jobs that are done [-].
    fn cooked(&self) -> usize {
        self.done + self.round.done().0
    }

    /// Returns how far the search has come.
    pub fn progress(&self) -> SearchProgress {
        SearchProgress { candidates: self.cooked(), share: self.share, stage: self.planner.stage() }
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

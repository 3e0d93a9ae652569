//! Where work is done: on another thread, in another instance of the program, or between frames.

use std::sync::Arc;

use saute_kitchen::Library;
use saute_plan::End;
use saute_plan::fit::run::FitRun;
use saute_plan::schedule::search::Search;
use web_time::{Duration, Instant};

use super::WorkKind;
use super::job::JobWorker;
use super::worker::Worker;
use crate::forecasts::foreseeing::Foreseeing;
use crate::playback::playing::Playing;

/// An executor for one kind of work, with its own foods and pans.
pub struct Executor {
    kind: WorkKind,
    worker: Box<dyn Worker>,
    /// Computing time since the last rest.
    worked: Duration,
}

impl Executor {
    /// An executor without an order.
    pub fn new(kind: WorkKind, library: Arc<Library>) -> Self {
        Self::at(End::Front, kind, library)
    }

    /// One of two that get the same orders and tell each other what they have done ([`WorkKind::is_shared`]).
    pub fn at(end: End, kind: WorkKind, library: Arc<Library>) -> Self {
        Self { kind, worker: worker(kind, library, end), worked: Duration::ZERO }
    }

    /// Takes an order in place of the one before.
    pub fn take(&mut self, order: &[u8]) {
        self.timed(|worker| worker.take(order));
    }

    /// Returns true while there is something to do.
    pub fn is_busy(&self) -> bool {
        self.worker.is_busy()
    }

    /// Works on for about `budget`; returns an answer where one is due.
    pub fn go_on(&mut self, budget: Duration) -> Option<Vec<u8>> {
        self.timed(|worker| worker.go_on(budget))
    }

    /// Takes what was done here since the last call, for the twin.
    pub fn share(&mut self) -> Option<Vec<u8>> {
        self.worker.share()
    }

    /// Takes what the twin has done.
    pub fn take_shared(&mut self, shares: &[u8]) {
        self.timed(|worker| worker.take_shared(shares));
    }

    /// How long it rests before it goes on; what was worked so far is rested for only once.
    pub fn rest(&mut self) -> Duration {
        std::mem::take(&mut self.worked).mul_f64(self.kind.rest_share())
    }

    fn timed<T>(&mut self, work: impl FnOnce(&mut dyn Worker) -> T) -> T {
        let begun = Instant::now();
        let done = work(&mut *self.worker);
        self.worked += begun.elapsed();
        done
    }
}

/// Who does a kind of work.
fn worker(kind: WorkKind, library: Arc<Library>, end: End) -> Box<dyn Worker> {
    match kind {
        WorkKind::Play => Box::new(Playing::new(library)),
        WorkKind::Forecast => Box::new(Foreseeing::new(library)),
        WorkKind::Plan => Box::new(JobWorker::<Search>::new(library, end)),
        WorkKind::Fit => Box::new(JobWorker::<FitRun>::new(library, end)),
    }
}

//! A helper without its own thread: it works a little whenever the window polls for answers, once a frame.

use std::sync::Arc;

use saute_kitchen::Library;
use web_time::{Duration, Instant};

use super::executor::Executor;
use super::{Agency, Helper, WorkKind};

/// How long a frame may work [ms] (chosen: a quarter of a frame at 60 frames a second).
const FRAME_MS: u64 = 4;

/// An executor in the window's own thread.
pub struct InFrames {
    executor: Executor,
    rests_until: Option<Instant>,
}

impl InFrames {
    /// An executor without an order.
    pub fn new(kind: WorkKind, library: &Arc<Library>) -> Self {
        Self { executor: Executor::new(kind, Arc::clone(library)), rests_until: None }
    }
}

impl Helper for InFrames {
    fn ask(&mut self, order: Vec<u8>) {
        self.executor.take(&order);
    }

    fn answers(&mut self) -> Option<Vec<Vec<u8>>> {
        let now = Instant::now();
        if !self.executor.is_busy() || self.rests_until.is_some_and(|until| now < until) {
            return Some(Vec::new());
        }
        let answer = self.executor.go_on(Duration::from_millis(FRAME_MS));
        self.rests_until = Some(Instant::now() + self.executor.rest());
        Some(answer.into_iter().collect())
    }

    fn needs_frames(&self) -> bool {
        self.executor.is_busy()
    }
}

/// Lets all work be done between frames.
pub struct Frames;

impl Agency for Frames {
    fn hire(&self, kind: WorkKind, library: &Arc<Library>) -> Box<dyn Helper> {
        Box::new(InFrames::new(kind, library))
    }
}

/// A helper whose place is taken in frames once it is of no use: its last order is done again.
pub struct OrInFrames {
    helper: Box<dyn Helper>,
    kind: WorkKind,
    library: Arc<Library>,
    order: Vec<u8>,
}

impl OrInFrames {
    /// Lets a helper work as long as it can.
    pub fn new(helper: Box<dyn Helper>, kind: WorkKind, library: &Arc<Library>) -> Self {
        Self { helper, kind, library: Arc::clone(library), order: Vec::new() }
    }
}

impl Helper for OrInFrames {
    fn ask(&mut self, order: Vec<u8>) {
        self.order.clone_from(&order);
        self.helper.ask(order);
    }

    fn answers(&mut self) -> Option<Vec<Vec<u8>>> {
        if let Some(answers) = self.helper.answers() {
            return Some(answers);
        }
        self.helper = Box::new(InFrames::new(self.kind, &self.library));
        self.helper.ask(self.order.clone());
        Some(Vec::new())
    }

    fn needs_frames(&self) -> bool {
        self.helper.needs_frames()
    }
}

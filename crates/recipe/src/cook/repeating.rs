//! The state of a repeated action.

use serde::{Deserialize, Serialize};

use crate::action::{Repeat, RepeatEnd};
use crate::cook::step_record::StepRecord;
use crate::cook::watch::Watch;
use saute_kitchen::kitchen::Kitchen;

/// A repeated action that goes on.
#[derive(Clone, Debug, Deserialize, Serialize)]
pub(crate) struct Repeating {
    /// Time of the last repetition, or of the step's start [s].
    pub(crate) last_s: f64,
    done: u32,
    watch: Watch,
}

/// What came of a look at a repeated action.
pub(crate) enum Progress {
    /// It was carried out again.
    Fired(StepRecord),
    /// It waits for its time or for the hands.
    Waits,
    /// It has ended.
    Done,
}

impl Repeating {
    /// Returns the state at the start [s].
    pub(crate) fn since(now: f64) -> Self {
        Self { last_s: now, done: 0, watch: Watch::default() }
    }

    /// Returns true once it ends.
    pub(crate) fn ends(&mut self, repeat: &Repeat, kitchen: &Kitchen) -> bool {
        match &repeat.end {
            RepeatEnd::Times(times) => self.done >= *times,
            RepeatEnd::Until(condition) => self.watch.look(condition, kitchen),
        }
    }

    /// Counts a repetition at a time [s].
    pub(crate) fn count(&mut self, now: f64) {
        self.done += 1;
        self.last_s = now;
    }
}

//! A line of time: what was done from the beginning to an end, with its keyframes and series.

use saute_kitchen::Kitchen;
use saute_recipe::probe::Probes;
use saute_recipe::{Moment, Recorder, Recording};

use super::keyframes::Keyframes;
use crate::mark::Mark;

/// Times closer than this count as equal [s] (chosen: rows state milliseconds; far below a frame).
const SAME_TIME: f64 = 1e-3;

/// A line of time.
#[derive(Clone)]
pub(super) struct Line {
    pub(super) recording: Recording,
    pub(super) keyframes: Keyframes,
    pub(super) traces: Traces,
}

/// Curves, probes and marks.
#[derive(Clone)]
pub(super) struct Traces {
    pub(super) recorder: Recorder,
    pub(super) probes: Probes,
    pub(super) marks: Vec<Mark>,
}

impl Traces {
    /// Returns them as they were at an instant. The row of that very instant is written again by whoever has the kitchen.
    pub(super) fn until(&self, moment: Moment) -> Self {
        let mut traces = self.clone();
        let time_s = moment.time_s();
        traces.recorder = traces.recorder.until(time_s + SAME_TIME);
        traces.probes.cut(time_s + SAME_TIME);
        traces.marks.retain(|mark| mark.at <= moment);
        traces
    }

    /// Writes the row of the present instant again, if there is one: what it shows was perhaps done after it.
    pub(super) fn settle(&mut self, kitchen: &Kitchen) {
        let has_row = |row: &saute_recipe::recorder::Row| (row.time_s - kitchen.time_s()).abs() < SAME_TIME;
        if self.recorder.rows.last().is_some_and(has_row) {
            self.recorder.write_row(kitchen);
        }
    }
}

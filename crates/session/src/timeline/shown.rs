//! The instant that is shown as a part of its line, and the keyframes that it leaves.

use saute_recipe::Recording;
use web_time::Duration;

use super::keyframes::{COMPUTED_PER_KEYFRAME, bytes_of};
use super::line::{Line, Traces};
use crate::Session;
use crate::hands::Hands;
use crate::mark::Mark;

/// Frames between two keyframes at least: one second (chosen: nobody aims finer).
const FRAMES_PER_KEYFRAME: u64 = 60;

impl<H: Hands> Session<H> {
    /// End of what can be scrubbed to [s].
    pub fn end_s(&self) -> f64 {
        self.longest().moment().time_s()
    }

    /// The instant that is shown, or on its way to be shown [s].
    pub fn shown_s(&self) -> f64 {
        self.here().time_s()
    }

    /// Returns true while a recorded session is played up to its end.
    pub fn catches_up(&self) -> bool {
        self.timeline.catches_up
    }

    /// All that was recorded, after the shown instant too; it is in no file yet.
    pub fn whole_recording(&self) -> Recording {
        let longest = self.longest();
        longest.fork(longest.moment())
    }

    /// The instant at which travelling ends [s].
    pub fn bound_for_s(&self) -> f64 {
        if self.timeline.catches_up { self.end_s() } else { self.shown_s() }
    }

    /// Everything that was done, after the shown instant too.
    pub fn all_marks(&self) -> &[Mark] {
        self.timeline.course.ahead.as_ref().map_or(&self.marks, |ahead| &ahead.line.traces.marks)
    }

    /// Size of all keyframes [bytes].
    pub fn keyframe_bytes(&mut self) -> usize {
        bytes_of(self.timeline.lists())
    }

    /// Number of keyframes of the cook that is shown.
    pub fn keyframe_count(&self) -> usize {
        let course = &self.timeline.course;
        course.ahead.as_ref().map_or(&course.keyframes, |ahead| &ahead.line.keyframes).len()
    }

    /// The line of time that is shown, with its number, for a file that follows it; none while something is ahead, or nothing was
    /// done.
    pub fn unsaved(&mut self) -> Option<(u64, &mut Recording)> {
        let is_at_end = !self.lies_ahead() && !self.is_travelling();
        let has_begun = !self.recording.entries().is_empty() || self.plays;
        (is_at_end && has_begun).then_some((self.timeline.number, &mut self.recording))
    }

    /// Keeps the instant that is shown as a keyframe.
    pub(crate) fn keep_keyframe(&mut self) {
        let moment = self.recording.moment();
        self.timeline.computed = Duration::ZERO;
        if self.timeline.course.keyframes.has(moment) {
            return;
        }
        self.timeline.course.models.learn(&self.kitchen);
        let (runner, plays) = self.runner_here();
        self.timeline.course.keyframes.keep(&self.kitchen, &runner, plays, moment);
        self.timeline.thin();
    }

    /// Packs keyframes a little where they need much room.
    pub(crate) fn pack_keyframes(&mut self) {
        self.timeline.pack_on();
    }

    /// Keeps a keyframe now and then.
    pub(crate) fn keep_keyframes(&mut self, computed: Duration) {
        self.timeline.computed += computed;
        self.pack_keyframes();
        let apart = self.timeline.apart().max(FRAMES_PER_KEYFRAME);
        let last = self.timeline.course.keyframes.before(self.recording.moment()).map_or(0, |k| k.moment.frame);
        let is_due = self.timeline.computed >= COMPUTED_PER_KEYFRAME;
        if is_due && self.kitchen.is_between_ticks() && self.kitchen.frame() >= last + apart {
            self.keep_keyframe();
        }
    }

    /// The line up to the instant that is shown.
    pub(super) fn line(&self) -> Line {
        Line {
            recording: self.recording.clone(),
            keyframes: self.timeline.course.keyframes.clone(),
            traces: self.traces(),
        }
    }

    pub(super) fn traces(&self) -> Traces {
        Traces { recorder: self.recorder.clone(), probes: self.probes.clone(), marks: self.marks.clone() }
    }

    pub(super) fn show_traces(&mut self, traces: Traces) {
        (self.recorder, self.probes, self.marks) = (traces.recorder, traces.probes, traces.marks);
    }
}

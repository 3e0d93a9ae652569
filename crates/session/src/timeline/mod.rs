//! The handle on time: undo, redo, scrubbing and branches of a cook.
//!
//! A session's recording ends at the instant that is shown. After a step back, `Ahead` holds the line that goes on from there: the
//! same commands up to that instant, and those that followed. Time that goes on after scrubbing follows it, command by command, until
//! its end is reached; a command of a person departs from it, and what lay ahead becomes a branch. After an undo, what was undone is not
//! followed: it becomes a branch as soon as time goes on.

mod acts;
mod beside;
mod branches;
mod keyframes;
mod line;
mod packed;
mod put_by;
mod travel;
mod undo;

use saute_kitchen::bytes::Models;
use saute_recipe::Moment;
use web_time::Duration;

pub use self::beside::{Stand, WayBeside};
pub use self::branches::{BranchName, MOST_BESIDE, Way};
pub use self::keyframes::MOST_BYTES;
pub use self::undo::Undone;

use self::branches::Branch;
use self::keyframes::Keyframes;
use self::line::Line;
use self::put_by::PutBy;
use self::travel::Travel;
use super::{Mark, Session};
use crate::hands::Hands;

/// Computing time between two keyframes (chosen: to reach any instant from a keyframe takes a part of a second).
const COMPUTED_PER_KEYFRAME: Duration = Duration::from_millis(250);
/// Frames between two keyframes at least: one second (chosen: nobody aims finer).
const FRAMES_PER_KEYFRAME: u64 = 60;

/// Everything that is beside the instant that is shown.
#[derive(Default)]
pub(super) struct Timeline {
    course: Course,
    travel: Option<Travel>,
    /// Cooks in place of which others began, and those that an undo put by in turn.
    past: Vec<PutBy>,
    later: Vec<PutBy>,
    /// Computing time since the last keyframe.
    computed: Duration,
    /// The keyframe that is being packed.
    packing: Option<keyframes::Packing>,
    /// True if keyframes need much room.
    is_narrow: bool,
    /// Number of the line of time that is shown, for the file that it is kept in.
    number: u64,
    /// Ways that began so far.
    ways: u64,
    /// Number of looks at the ways beside the one that is shown: each has its turn to be the first.
    looks: usize,
    /// True while a recorded session is played up to its end.
    pub(super) catches_up: bool,
    /// True while a person holds the strip: time stands still.
    pub(super) is_held: bool,
}

/// What belongs to one cook.
#[derive(Default)]
pub(super) struct Course {
    keyframes: Keyframes,
    ahead: Option<Ahead>,
    /// Instants to which redo leads, the next one last.
    redo: Vec<Moment>,
    branches: Vec<Branch>,
    /// The way that is shown.
    way: Way,
    /// True if the last branch was undone, and no command was given since.
    is_last_undone: bool,
    /// Entries that the beginning itself made.
    given: usize,
    /// Models of its kitchens: they go with it.
    models: Models,
}

/// What was done after the instant that is shown.
pub(super) struct Ahead {
    line: Line,
    /// True if it happens again when time goes on.
    is_followed: bool,
}

impl Timeline {
    /// A cook begins.
    pub(super) fn begin(&mut self) {
        self.course = Course::default();
        self.begin_way();
        self.number += 1;
        self.travel = None;
        self.catches_up = false;
    }

    /// What is shown is a new way, in the first place that is free.
    fn begin_way(&mut self) {
        self.ways += 1;
        let branches = &self.course.branches;
        let is_free = |slot: &usize| branches.iter().all(|branch| branch.way.slot != *slot);
        let slot = (0..MOST_BESIDE).find(is_free).unwrap_or(MOST_BESIDE);
        self.course.way = Way { slot, id: self.ways };
    }

    /// Models that are known.
    pub(super) fn models(&mut self) -> &mut Models {
        &mut self.course.models
    }

    /// Frames between two keyframes at least where room is scarce: what is closer would be dropped first.
    fn apart(&self) -> u64 {
        let course = &self.course;
        let keyframes = course.ahead.as_ref().map_or(&course.keyframes, |ahead| &ahead.line.keyframes);
        if self.is_narrow { keyframes.usual_gap() / 2 } else { 0 }
    }

    fn lists(&mut self) -> impl Iterator<Item = &mut Keyframes> {
        let courses = self.past.iter_mut().chain(&mut self.later).map(|by| &mut by.course);
        courses.chain([&mut self.course]).flat_map(|course| {
            let ahead = course.ahead.iter_mut().map(|ahead| &mut ahead.line.keyframes);
            let branches = course.branches.iter_mut().map(|branch| &mut branch.line.keyframes);
            ahead.chain(branches).chain([&mut course.keyframes])
        })
    }
}

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
    pub fn whole_recording(&self) -> saute_recipe::Recording {
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
        keyframes::bytes_of(self.timeline.lists())
    }

    /// Number of keyframes of the cook that is shown.
    pub fn keyframe_count(&self) -> usize {
        let course = &self.timeline.course;
        course.ahead.as_ref().map_or(&course.keyframes, |ahead| &ahead.line.keyframes).len()
    }

    /// The line of time that is shown, with its number, for a file that follows it; none while something lies ahead, or nothing was
    /// done.
    pub fn unsaved(&mut self) -> Option<(u64, &mut saute_recipe::Recording)> {
        let is_at_end = !self.lies_ahead() && !self.is_travelling();
        let has_begun = !self.recording.entries().is_empty() || self.plays;
        (is_at_end && has_begun).then_some((self.timeline.number, &mut self.recording))
    }

    /// Keeps the instant that is shown as a keyframe.
    pub(super) fn keep_keyframe(&mut self) {
        let moment = self.recording.moment();
        self.timeline.computed = Duration::ZERO;
        if self.timeline.course.keyframes.has(moment) {
            return;
        }
        self.timeline.course.models.learn(&self.kitchen);
        let (runner, plays) = self.runner_here();
        self.timeline.course.keyframes.keep(&self.kitchen, &runner, plays, moment);
        keyframes::thin(&mut self.timeline);
    }

    /// Packs keyframes a little where they need much room.
    pub(super) fn pack_keyframes(&mut self) {
        keyframes::pack_on(&mut self.timeline);
    }

    /// Keeps a keyframe now and then.
    pub(super) fn keep_keyframes(&mut self, computed: Duration) {
        self.timeline.computed += computed;
        self.pack_keyframes();
        let apart = self.timeline.apart().max(FRAMES_PER_KEYFRAME);
        let last = self.timeline.course.keyframes.before(self.recording.moment()).map_or(0, |k| k.moment.frame);
        let is_due = self.timeline.computed >= COMPUTED_PER_KEYFRAME;
        if is_due && self.kitchen.is_between_ticks() && self.kitchen.frame() >= last + apart {
            self.keep_keyframe();
        }
    }
}

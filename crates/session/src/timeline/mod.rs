//! The handle on time: undo, redo, scrubbing and branches of a cook.
//!
//! A session's recording ends at the instant that is shown. After a step back, `Ahead` contains the line that goes on from there: the
//! same commands up to that instant, and those that followed. Time that goes on after scrubbing follows it, command by command, until
//! its end is reached; a command of a person departs from it, and what was ahead becomes a branch. After an undo, what was undone is not
//! followed: it becomes a branch as soon as time goes on.

mod acts;
mod beside;
mod branch;
mod departing;
mod keyframes;
mod line;
mod packed;
mod put_by;
mod room;
mod shown;
mod travel;
mod turning;
mod undo;
mod undone;
mod way;

use std::collections::BTreeMap;
use std::sync::Arc;

use saute_kitchen::Library;
use saute_kitchen::bytes::Models;
use saute_recipe::{Moment, Recipe, Recording};
use web_time::Duration;

pub use self::branch::BranchName;
pub use self::keyframes::MOST_BYTES;
pub use self::undone::Undone;
pub use self::way::{MOST_BESIDE, Stand, Way, WayBeside};

use self::branch::Branch;
use self::keyframes::Keyframes;
use self::line::{Line, Traces};
use self::travel::Travel;
use crate::choice::FoodChoice;

/// Everything except the instant that is shown.
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
    /// Number of looks at the ways next to the one that is shown: each has its turn to be the first.
    looks: usize,
    /// True while a recorded session is played up to its end.
    pub(super) catches_up: bool,
    /// True while a person holds the strip: time is stopped.
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

/// A cook that was put by.
struct PutBy {
    course: Course,
    recording: Recording,
    traces: Traces,
    library: Arc<Library>,
    recipe: Arc<Recipe>,
    plays: bool,
    choice: FoodChoice,
    start_mass_g: BTreeMap<String, f64>,
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

//! Branches: other ways that the cook went.

use saute_recipe::session::{Deed, Done, Entry};
use saute_recipe::{Moment, Recording};

use super::Ahead;
use super::line::Line;
use super::travel::Travel;
use crate::Session;
use crate::hands::Hands;

/// Branches that are kept beside the one that is shown (chosen: four ways fit side by side).
pub const MOST_BESIDE: usize = 3;

/// Which of the ways that a cook went: it stays the same while others are gone over to.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Way {
    /// Its place among the ways from 0: the lowest that was free when it began, below [`MOST_BESIDE`] + 1.
    pub slot: usize,
    /// A number that no other way has.
    pub id: u64,
}

/// A way beside the one that is shown.
pub(super) struct Branch {
    pub(super) way: Way,
    pub(super) line: Line,
    /// Where it is seen beside the others.
    pub(super) seen: Option<Travel>,
}

/// What a branch is called by: the act by which it differs from the one that is shown.
#[derive(Clone, Debug, PartialEq)]
pub struct BranchName {
    /// The act; none if nothing was done that differs.
    pub done: Option<Done>,
    /// When it was done, or when the two part [s].
    pub at_s: f64,
}

impl<H: Hands> Session<H> {
    /// An act is done here: what lay ahead of the first `entries` becomes a branch.
    pub(crate) fn depart(&mut self, entries: usize) {
        let course = &mut self.timeline.course;
        course.redo.clear();
        course.is_last_undone = false;
        self.timeline.later.clear();
        self.part_from_ahead(entries);
    }

    /// Time goes on without what was undone: it becomes a branch, to which redo leads until another act is done.
    pub(crate) fn let_go_of_undone(&mut self) {
        let undone = |ahead: &super::Ahead| !ahead.is_followed;
        if self.timeline.course.ahead.as_ref().is_some_and(undone) {
            self.timeline.course.redo.clear();
            let entries = self.recording.entries().len();
            self.timeline.course.is_last_undone = self.part_from_ahead(entries);
        }
    }

    /// Keeps what lies ahead as a branch if it has acts after the first `entries`; returns true if it does.
    fn part_from_ahead(&mut self, entries: usize) -> bool {
        let Some(ahead) = self.timeline.course.ahead.take() else { return false };
        let has_acts = ahead.line.recording.entries().len() > entries;
        if has_acts {
            self.keep_branch(ahead.line);
        }
        has_acts
    }

    /// Keeps the way that is left as a branch; the oldest one makes room. What is shown is a new way.
    fn keep_branch(&mut self, line: Line) {
        let way = self.timeline.course.way;
        let branches = &mut self.timeline.course.branches;
        branches.push(Branch { way, line, seen: None });
        let surplus = branches.len().saturating_sub(MOST_BESIDE);
        branches.drain(..surplus);
        self.timeline.begin_way();
    }

    /// Names of the branches, by what differs from the one that is shown.
    pub fn branches(&self) -> Vec<BranchName> {
        let shown = self.longest();
        self.timeline.course.branches.iter().map(|branch| name_of(&branch.line.recording, shown)).collect()
    }

    /// Goes over to a branch at the same time, or at its end; the one that was shown becomes a branch.
    pub fn go_to_branch(&mut self, place: usize, keeps: bool) {
        self.finish_travel();
        if place >= self.timeline.course.branches.len() {
            return;
        }
        self.keep_keyframe();
        let to = self.beside(&self.timeline.course.branches[place].line.recording).moment();
        let course = &mut self.timeline.course;
        let other = course.branches.remove(place);
        course.is_last_undone = false;
        course.redo.clear();
        let way = std::mem::replace(&mut course.way, other.way);
        let ahead = course.ahead.take().map(|ahead| ahead.line);
        let line = ahead.unwrap_or_else(|| self.line());
        if keeps {
            self.timeline.course.branches.insert(place, Branch { way, line, seen: None });
        }
        let to = if keeps { to } else { other.line.recording.moment() };
        self.go_onto(other, to);
    }

    /// Shows another way at a moment of it.
    fn go_onto(&mut self, branch: Branch, to: Moment) {
        let Branch { mut seen, line, .. } = branch;
        let known = (&mut self.timeline.course.models, 0);
        let replay = Travel::toward(to, &mut seen, &line, &self.library, known).into_replay();
        let from = replay.moment();
        self.kitchen = replay.kitchen.clone();
        self.recording = line.recording.clone();
        self.recording.truncate(from);
        self.show_traces(line.traces.until(to));
        self.timeline.course.keyframes = line.keyframes.until(from);
        self.timeline.course.ahead = Some(Ahead { line, is_followed: true });
        self.timeline.number += 1;
        self.take_kitchen(replay);
        self.travel_to(to, true);
        self.rejoin();
    }
}

/// Number of the first entries that two recordings share.
pub(super) fn shared_entries(one: &Recording, other: &Recording) -> usize {
    one.entries().iter().zip(other.entries()).take_while(|(a, b)| a == b).count()
}

/// The act by which a recording differs from another one.
pub(super) fn name_of(recording: &Recording, other: &Recording) -> BranchName {
    let same = shared_entries(recording, other);
    let own = recording.entries()[same..].iter().find(|entry| entry.deed != Deed::TakeOver);
    let theirs = other.entries().get(same);
    let at = own.or(theirs).map_or_else(|| recording.moment().time_s(), Entry::time_s);
    BranchName { done: own.map(|entry| Done::from(&entry.deed)), at_s: at }
}

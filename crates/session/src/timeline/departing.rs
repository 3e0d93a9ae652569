//! Branches are parted from, kept and gone over to.

use saute_recipe::Moment;

use super::Ahead;
use super::branch::{Branch, BranchName, name_of};
use super::line::Line;
use super::travel::Travel;
use super::way::MOST_BESIDE;
use crate::Session;
use crate::hands::Hands;

impl<H: Hands> Session<H> {
    /// An act is done here: what was ahead of the first `entries` becomes a branch.
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

    /// Keeps what is ahead as a branch if it has acts after the first `entries`; returns true if it does.
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

//! Branches side by side: each way that the cook went, as it is at the instant that is shown.
//!
//! Where two ways have not parted yet they are the same, and no second kitchen is computed. A way that has parted is replayed up to the
//! instant from the last keyframe before it, in slices of a frame's time, and from then on follows the clock.

use std::collections::BTreeMap;

use saute_recipe::{Moment, Recording};
use web_time::Duration;

use super::Course;
use super::branch::{Branch, BranchName, name_of, shared_entries};
use super::travel::Travel;
use super::way::{Stand, Way, WayBeside};
use crate::Session;
use crate::hands::Hands;
use crate::playback::Purpose;

/// The instant of a branch that belongs to the one that is shown.
#[derive(Clone, Copy)]
pub(super) enum Beside {
    /// The shown one itself: the two part at this frame, or never.
    Shared(Moment, u64),
    /// A separate instant.
    Own(Moment),
    /// Its end, which is before.
    End(Moment),
}

impl Beside {
    pub(super) fn moment(self) -> Moment {
        match self {
            Self::Shared(moment, _) | Self::Own(moment) | Self::End(moment) => moment,
        }
    }
}

impl<H: Hands> Session<H> {
    /// The way that is shown.
    pub fn way(&self) -> Way {
        self.timeline.course.way
    }

    /// All ways.
    pub fn all_ways(&self) -> impl Iterator<Item = Way> {
        let course = &self.timeline.course;
        course.branches.iter().map(|branch| branch.way).chain([course.way])
    }

    /// Returns true if the cook went other ways, too.
    pub fn has_branches(&self) -> bool {
        !self.timeline.course.branches.is_empty()
    }

    /// The instant of another recording that belongs next to the one that is shown, or on its way to be shown.
    pub(super) fn beside(&self, other: &Recording) -> Beside {
        let (here, longest, end) = (self.here(), self.longest(), other.moment());
        let shared = shared_entries(longest, other);
        let next = |recording: &Recording| recording.entries().get(shared).map_or(u64::MAX, |entry| entry.frame);
        let parting = next(longest).min(next(other));
        if here.frame > end.frame {
            Beside::End(end)
        } else if here.entries <= shared && here.frame <= parting {
            Beside::Shared(here, parting.min(end.frame))
        } else {
            Beside::Own(other.moment_at(here.frame))
        }
    }

    /// All ways in the order of their slots, each as it is at the instant that is shown or as near as it has come.
    pub fn ways(&self) -> Vec<WayBeside<'_>> {
        let course = &self.timeline.course;
        let rows = course.ahead.as_ref().map_or(&self.recorder.rows, |ahead| &ahead.line.traces.recorder.rows);
        let live = WayBeside { way: course.way, place: None, kitchen: &self.kitchen, rows, stand: Stand::Live };
        let others = course.branches.iter().enumerate().map(|(place, branch)| self.way_beside(place, branch));
        let mut ways: Vec<WayBeside> = std::iter::once(live).chain(others).collect();
        ways.sort_by_key(|way| way.way.slot);
        ways
    }

    fn way_beside<'a>(&'a self, place: usize, branch: &'a Branch) -> WayBeside<'a> {
        let beside = self.beside(&branch.line.recording);
        let seen = branch.seen.as_ref().filter(|_| !matches!(beside, Beside::Shared(..)));
        let at_s = seen.map_or(0.0, |travel| travel.replay.moment().time_s());
        let has_arrived = seen.is_some_and(|travel| travel.replay.moment().frame == beside.moment().frame);
        let stand = match beside {
            Beside::Shared(_, parting) => Stand::Same(parting as f64 * saute_kitchen::FRAME_S),
            Beside::End(end) if has_arrived => Stand::Ended(end.time_s()),
            Beside::Own(_) if has_arrived => Stand::Here,
            Beside::End(_) | Beside::Own(_) => Stand::CatchingUp(at_s),
        };
        WayBeside {
            way: branch.way,
            place: Some(place),
            kitchen: seen.map_or(&self.kitchen, |travel| &travel.replay.kitchen),
            rows: &branch.line.traces.recorder.rows,
            stand,
        }
    }

    /// Names of all ways by their numbers: the act by which each differs from the one that is most like it.
    pub fn way_names(&self) -> BTreeMap<u64, BranchName> {
        let course = &self.timeline.course;
        let branches = course.branches.iter().map(|branch| (branch.way.id, &branch.line.recording));
        let all = branches.chain([(course.way.id, self.longest())]);
        all.map(|(id, recording)| (id, self.way_name(recording))).collect()
    }

    /// The act by which a way differs from the one with which it shares most.
    fn way_name(&self, recording: &Recording) -> BranchName {
        let branches = self.timeline.course.branches.iter().map(|branch| &branch.line.recording);
        let others = branches.chain([self.longest()]).filter(|other| !std::ptr::eq(*other, recording));
        let nearest = others.max_by_key(|other| shared_entries(recording, other));
        name_of(recording, nearest.unwrap_or(recording))
    }

    /// Brings the other ways nearer to the instant that is shown, for no longer than `budget`; at least by a frame each. Returns true
    /// while one is on its way.
    pub fn keep_beside(&mut self, budget: Duration) -> bool {
        let recordings = self.timeline.course.branches.iter().map(|branch| &branch.line.recording);
        let targets: Vec<Beside> = recordings.map(|recording| self.beside(recording)).collect();
        let count = targets.len();
        let each = budget / count.max(1) as u32;
        let kept: usize = self.branch_keyframes();
        self.timeline.looks += 1;
        let first = self.timeline.looks;
        let (mut may_turn_back, mut is_behind) = (true, false);
        for place in (0..count).map(|k| (k + first) % count) {
            if let Beside::Own(to) | Beside::End(to) = targets[place] {
                is_behind |= !self.bring_beside(place, to, each, &mut may_turn_back);
            }
        }
        if self.branch_keyframes() != kept {
            self.timeline.thin();
        }
        is_behind
    }

    fn branch_keyframes(&self) -> usize {
        self.timeline.course.branches.iter().map(|branch| branch.line.keyframes.len()).sum()
    }

    /// Brings a branch nearer to a moment; returns true if it is there. Reading a keyframe takes time: one in a frame is.
    fn bring_beside(&mut self, place: usize, to: Moment, budget: Duration, may_turn_back: &mut bool) -> bool {
        let apart = self.timeline.apart();
        let Course { branches, models, .. } = &mut self.timeline.course;
        let Branch { way, line, seen } = &mut branches[place];
        if seen.as_ref().is_some_and(|travel| travel.replay.moment() == to) {
            return true;
        }
        let is_near = seen.as_ref().is_some_and(|travel| travel.is_near(to, line));
        if !is_near && !std::mem::take(may_turn_back) {
            return false;
        }
        let mut travel = Travel::toward(to, seen, line, &self.library, (models, apart));
        let purpose = Purpose::Beside(way.id);
        if self.playback.play_elsewhere(purpose, &mut travel, line, &self.library, models) {
            *seen = Some(travel);
            return false;
        }
        let has_arrived = travel.go_on(line, &self.library, budget);
        *seen = Some(travel);
        has_arrived
    }

    /// Lets go of the kitchens of the other ways.
    pub fn forget_beside(&mut self) {
        self.timeline.course.branches.iter_mut().for_each(|branch| branch.seen = None);
    }
}

//! Undo and redo: back to before the last act, and forward again.

use saute_recipe::session::Done;

use super::acts::last_act;
use super::undone::Undone;
use crate::Session;
use crate::hands::Hands;

impl<H: Hands> Session<H> {
    /// Goes back to before the last act, and stops there; returns what was undone.
    pub fn undo(&mut self) -> Option<Undone> {
        if self.timeline.catches_up {
            self.finish_travel();
        }
        let here = self.here();
        let (longest, given) = (self.longest(), self.timeline.course.given);
        let Some(first) = last_act(longest.entries(), given, here.entries) else {
            self.finish_travel();
            return self.bring_back().then_some(Undone::Beginning);
        };
        let (to, done) = (longest.before(first)?, Done::from(&longest.entries()[first].deed));
        self.timeline.course.redo.push(here);
        self.travel_to(to, false);
        self.set_paused(true);
        Some(Undone::Act(done))
    }

    /// Goes forward to where the last undo began; returns false if nothing was undone.
    pub fn redo(&mut self) -> bool {
        if let Some(to) = self.timeline.course.redo.pop() {
            self.travel_to(to, false);
            return true;
        }
        self.finish_travel();
        if self.bring_later() {
            return true;
        }
        if self.timeline.course.ahead.is_some() {
            let end = self.longest().moment();
            self.travel_to(end, true);
            return true;
        }
        let Some(last) = self.timeline.course.branches.len().checked_sub(1) else { return false };
        let is_undone = self.timeline.course.is_last_undone;
        if is_undone {
            self.go_to_branch(last, false);
            self.set_paused(true);
        }
        is_undone
    }

    /// Returns true if an act or a new beginning can be undone.
    pub fn can_undo(&self) -> bool {
        let course = &self.timeline.course;
        let acts = last_act(self.longest().entries(), course.given, self.here().entries);
        acts.is_some() || !self.timeline.past.is_empty()
    }

    /// Returns true if something was undone and can be done again.
    pub fn can_redo(&self) -> bool {
        let course = &self.timeline.course;
        !course.redo.is_empty() || course.ahead.is_some() || course.is_last_undone || !self.timeline.later.is_empty()
    }
}

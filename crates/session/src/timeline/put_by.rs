//! Cooks in place of which another one began: starting over can be undone.

use std::sync::Arc;

use super::PutBy;
use crate::Session;
use crate::hands::Hands;

/// Cooks that are kept (chosen: who starts over more often does not look for the first one).
const MOST: usize = 4;

impl<H: Hands> Session<H> {
    /// Puts the present cook by, for another that begins.
    pub(crate) fn put_by(&mut self) {
        self.finish_travel();
        self.timeline.later.clear();
        let has_begun = self.recording.entries().len() > self.timeline.course.given || self.kitchen.frame() > 0;
        if has_begun || self.timeline.course.ahead.is_some() {
            let present = self.take_present();
            self.timeline.past.push(present);
            let surplus = self.timeline.past.len().saturating_sub(MOST);
            self.timeline.past.drain(..surplus);
        }
    }

    /// Forgets all cooks that were put by.
    pub fn forget_put_by(&mut self) {
        self.timeline.past.clear();
        self.timeline.later.clear();
    }

    /// Counts what the beginning itself made: it is not undone by itself.
    pub(crate) fn end_of_beginning(&mut self) {
        self.timeline.course.given = self.recording.entries().len();
        self.timeline.course.is_last_undone = false;
    }

    fn take_present(&mut self) -> PutBy {
        self.keep_keyframe();
        self.forget_beside();
        PutBy {
            course: std::mem::take(&mut self.timeline.course),
            recording: self.recording.clone(),
            traces: self.traces(),
            library: Arc::clone(&self.library),
            recipe: Arc::clone(&self.recipe),
            plays: self.plays,
            choice: self.choice.clone(),
            start_mass_g: self.start_mass_g.clone(),
        }
    }

    /// Brings back the cook that was put by last; returns false if there is none.
    pub(super) fn bring_back(&mut self) -> bool {
        let Some(last) = self.timeline.past.pop() else { return false };
        let present = self.take_present();
        self.timeline.later.push(present);
        self.bring(last);
        true
    }

    /// Brings back the cook that was put by when an earlier one was brought back.
    pub(super) fn bring_later(&mut self) -> bool {
        let Some(next) = self.timeline.later.pop() else { return false };
        let present = self.take_present();
        self.timeline.past.push(present);
        self.bring(next);
        true
    }

    fn bring(&mut self, by: PutBy) {
        self.timeline.course = by.course;
        self.timeline.number += 1;
        self.library = by.library;
        (self.recipe, self.plays, self.choice) = (by.recipe, by.plays, by.choice);
        self.start_mass_g = by.start_mass_g;
        let moment = by.recording.moment();
        let nearest = self.timeline.course.keyframes.before(moment).cloned();
        let nearest = nearest.expect("the beginning is a keyframe");
        let mut replay = nearest.replay(&self.library, &mut self.timeline.course.models);
        replay.run_to(&by.recording, &self.library, moment);
        self.recording = by.recording;
        self.show_traces(by.traces);
        self.take_kitchen(replay);
    }
}

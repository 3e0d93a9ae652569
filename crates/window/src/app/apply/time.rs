//! Undo, redo, scrubbing and branches by acts.

use crate::app::SauteApp;
use saute_session::timeline::Undone;
use saute_words::act_words::act_words;
use saute_words::clock::clock;

impl SauteApp {
    /// Goes back to before the last act, and shows a notice.
    pub(super) fn undo(&mut self) {
        let (undone, l) = (self.session.undo(), self.settings.language);
        self.time_was_turned();
        match undone {
            Some(Undone::Act(done)) => {
                let (what, time) = (act_words(&done, l), clock(self.session.shown_s()));
                let parts: [(&str, &dyn std::fmt::Display); 2] = [("what", &what), ("time", &time)];
                self.desk.notice.say(l.fill("notice.undone", &parts));
            }
            Some(Undone::Beginning) => self.say("notice.undone_restart"),
            None => self.say("notice.nothing_to_undo"),
        }
    }

    /// Goes forward again, and shows a notice.
    pub(super) fn redo(&mut self) {
        let done = self.session.redo();
        self.time_was_turned();
        let time = clock(self.session.shown_s());
        match done {
            true => self.desk.notice.say(self.settings.language.fill("notice.redone", &[("time", &time)])),
            false => self.say("notice.nothing_to_redo"),
        }
    }

    /// Turns time to an instant [s].
    pub(super) fn scrub(&mut self, time_s: f64) {
        self.session.scrub(time_s);
        self.time_was_turned();
    }

    /// Turns time to an instant from which another way is tried [s].
    pub(super) fn try_from(&mut self, time_s: f64) {
        self.session.try_from(time_s);
        self.time_was_turned();
    }

    /// Goes over to another branch.
    pub(super) fn go_to_branch(&mut self, place: usize) {
        self.session.go_to_branch(place, true);
        self.time_was_turned();
    }

    /// What hands held and where the eye was going belong to another instant.
    fn time_was_turned(&mut self) {
        self.inputs.pan_keys = Default::default();
        (self.sights.glance, self.sights.taken_out, self.sights.looks_again) = (None, None, true);
    }
}

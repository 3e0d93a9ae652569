//! Acts that are given while time is turned: they are done as soon as the instant is reached.

use crate::app::SauteApp;
use crate::app::apply::waiting::Waiting;
use saute_controls::act::{Act, TimeAct};
use saute_kitchen::Command;

impl SauteApp {
    /// Keeps an act that changes the cook for when the instant is reached to which time is turned; returns true if it waits now. Time
    /// that is turned again lets go of what waited.
    pub(crate) fn puts_off(&mut self, act: &Act) -> bool {
        if !self.session.is_travelling() {
            return false;
        }
        match act {
            Act::Time(TimeAct::Undo) => self.takes_back_waiting() || self.session.catches_up(),
            Act::Time(TimeAct::Redo) => self.session.catches_up(),
            Act::Time(TimeAct::Scrub(_)) => {
                self.pace.waiting.clear();
                false
            }
            act if act.traits().waits => {
                self.wait_with(Waiting::Act(act.clone()));
                true
            }
            _ => false,
        }
    }

    /// Keeps a command for then; what a hand does all the time is not kept.
    pub(crate) fn puts_off_command(&mut self, command: &Command) -> bool {
        let is_travelling = self.session.is_travelling();
        if is_travelling && !command.is_motion() {
            self.wait_with(Waiting::Command(command.clone()));
        }
        is_travelling
    }

    fn wait_with(&mut self, waiting: Waiting) {
        if self.pace.waiting.last().is_some_and(|last| waiting.replaces(last)) {
            self.pace.waiting.pop();
        }
        if self.pace.waiting.last() != Some(&waiting) {
            self.pace.waiting.push(waiting);
        }
    }

    /// Undo takes back what waits, the last first.
    fn takes_back_waiting(&mut self) -> bool {
        let last = self.pace.waiting.pop();
        if let Some(waiting) = &last {
            let what = waiting.words(self.settings.language);
            self.desk.notice.say(self.settings.language.fill("waiting.taken_back", &[("what", &what)]));
        }
        last.is_some()
    }

    /// Does what waited, once the instant is reached.
    pub(crate) fn do_what_waited(&mut self, ctx: &egui::Context) {
        if self.session.is_travelling() {
            return;
        }
        for waiting in std::mem::take(&mut self.pace.waiting) {
            match waiting {
                Waiting::Act(act) => self.act(act, ctx),
                Waiting::Command(command) => self.command(&command),
            }
        }
    }
}

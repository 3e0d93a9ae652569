//! The cook that goes on is kept, so that a window that is closed, or killed, can go on with it.

use crate::app::SauteApp;
use crate::app::keeps::later::Later;
use saute_recipe::Recording;
use saute_recipe::session::limits;
use saute_session::kept::autosave::{Autosave, CookStore};

impl SauteApp {
    /// Keeps the cook from now on. What was kept of an earlier cook is offered first.
    pub fn keep_cook_by(&mut self, store: Box<dyn CookStore>, earlier: Option<&[u8]>) {
        let stored = earlier.and_then(|bytes| Recording::from_file(bytes).ok());
        // A cook in which nothing was done is set out again soon enough.
        let has_begun = |recording: &Recording| !recording.entries().is_empty() || recording.beginning().plays;
        let offered = stored.map(|opened| opened.recording).filter(has_begun);
        self.keeps.autosave = Autosave { store: Some(store), kept: None, offered };
    }

    /// How far the cook came with which the window offers to go on [s].
    pub fn offered_s(&self) -> Option<f64> {
        self.keeps.autosave.offered.as_ref().map(|recording| recording.moment().time_s())
    }

    /// How much of the cook was handed to the place that keeps it [s]; none before the first writing.
    pub fn kept_s(&self) -> Option<f64> {
        self.keeps.autosave.kept.map(|kept| kept.time_s)
    }

    /// Goes on with the cook that is offered, or leaves it.
    pub(crate) fn decide_on_offer(&mut self, goes_on: bool) {
        let Some(offered) = self.keeps.autosave.offered.take() else { return };
        if !goes_on {
            return;
        }
        let is_to_build = self.session.builds_recorded_first(&offered);
        if self.waits_for_food(is_to_build, || Later::Offer) {
            self.keeps.autosave.offered = Some(offered);
            return;
        }
        if let Err(error) = self.session.resume(offered) {
            self.say_trouble(&error);
        }
    }

    /// Writes what happened, a few times a second, or at once. An error is reported once; then nothing is kept any longer.
    pub fn keep_cook(&mut self, at_once: bool) {
        if self.keeps.autosave.offered.is_some() {
            return;
        }
        let error = match self.keeps.autosave.follow(&mut self.session, at_once) {
            Ok(false) => return,
            // Another cook is kept again.
            Ok(true) => limits(),
            Err(error) => {
                self.keeps.autosave = Autosave::default();
                error
            }
        };
        self.desk.notice.say(self.settings.language.fill("notice.not_kept", &[("error", &error)]));
    }
}

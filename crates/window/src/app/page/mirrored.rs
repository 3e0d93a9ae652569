//! The panels a second time, as HTML beside the canvas: what egui gives screen readers goes to the page's script, and what is done
//! there comes back.

use crate::app::SauteApp;
use egui::accesskit::{Action, ActionData};
use saute_controls::spoken::told::told;
use web_time::{Duration, Instant};

/// Time between two descriptions of the cook (chosen: whoever requests one hears the present status).
const TELL_EVERY: Duration = Duration::from_secs(5);

impl SauteApp {
    /// Shows the page what the panels show, if that is new, announces what happens, and describes the status of the cook now and then.
    pub(super) fn show_mirrored(&mut self) {
        let Some(host) = &self.host.script else { return };
        if let Some(text) = self.host.mirrored.news(self.card_is_open()) {
            host.show_controls(&text);
        }
        let (order, l) = (self.desk.memory.now.order.as_ref(), self.settings.language);
        for sentence in self.host.mirrored.announcer.news(&self.session, order, &self.desk.notice, l) {
            host.announce(&sentence);
        }
        if self.host.mirrored.told.is_none_or(|at| at.elapsed() >= TELL_EVERY) {
            self.host.mirrored.told = Some(Instant::now());
            host.describe(&told(&self.session, &self.settings));
        }
    }

    /// Draws a frame soon: something has come for the window.
    pub fn wake(&self) {
        self.host.mirrored.wake();
    }

    /// Presses a control of the page.
    pub fn press_control(&self, id: &str) {
        self.ask_control(id, Action::Click, None);
    }

    /// Sets the value of a control of the page: a text, else a number.
    pub fn set_control(&self, id: &str, value: &str, is_text: bool) {
        let number = value.parse().ok().filter(|_| !is_text).map(ActionData::NumericValue);
        let data = number.unwrap_or_else(|| ActionData::Value(value.into()));
        self.ask_control(id, Action::SetValue, Some(data));
    }

    fn ask_control(&self, id: &str, action: Action, data: Option<ActionData>) {
        self.host.mirrored.ask(id, action, data);
    }
}

//! The page's script, as the window calls it.

use crate::act::Card;
use crate::app::SauteApp;
use crate::browser::host::{HostPlays, PageStart, Surroundings};

impl SauteApp {
    /// Opens the cook of the address, and keeps the cook in the browser's storage.
    pub(crate) fn settle_in(&mut self, around: Surroundings, ctx: &egui::Context) {
        self.page.mirrored.listen(ctx);
        let PageStart { host, kept, link, is_embedded } = around.0;
        self.page.host = host;
        if let Some(host) = self.page.host.clone() {
            self.let_listen(Box::new(HostPlays::new(host.clone())));
            self.employ(Box::new(host));
        }
        if is_embedded && self.desk.card == Some(Card::FirstSteps) {
            self.desk.card = None;
        }
        self.open_link(&link);
        if let Some(host) = self.page.host.clone() {
            self.keep_cook_by(Box::new(host), kept.as_deref());
        }
    }

    /// Copies a text to the clipboard, by the page's script.
    pub(crate) fn copy_text(&self, text: &str) {
        if let Some(host) = &self.page.host {
            host.copy_text(text);
        }
    }
}

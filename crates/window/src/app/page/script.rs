//! The page's script, as the window calls it.

use crate::app::SauteApp;
use crate::browser::host::{HostPlays, Opening, PageStart};
use saute_controls::act::Card;
use saute_session::FoodChoice;

impl SauteApp {
    /// Opens the cook of the address, and keeps the cook in the browser's storage.
    pub(super) fn begin_page(&mut self, start: PageStart, ctx: &egui::Context) {
        self.host.mirrored.listen(ctx);
        let PageStart { host, kept, link, is_embedded, opening, version } = start;
        (self.host.script, self.host.version) = (host.clone(), version);
        if let Some(host) = host.clone() {
            self.let_listen(Box::new(HostPlays::new(host.clone())));
            self.employ(Box::new(host));
        }
        self.open_as_chosen(opening);
        if is_embedded && self.desk.card == Some(Card::FirstSteps) {
            self.desk.card = None;
        }
        self.open_link(&link);
        if let Some(host) = host {
            self.keep_cook_by(Box::new(host), kept.as_deref());
        }
    }

    /// Opens what was chosen before the window was there.
    fn open_as_chosen(&mut self, opening: Opening) {
        if opening.is_chosen {
            self.shut_card(Card::FirstSteps);
        }
        if let Some(kind) = opening.food {
            let size_mm = self.session.library.foods.get(&kind).map(|food| food.size.default_mm.clone());
            let choice = FoodChoice { kind, size_mm: size_mm.unwrap_or_default(), ..FoodChoice::default() };
            if self.settings.choice != choice {
                self.settings.choice = choice;
                self.set_out(1);
            }
        }
        if opening.is_cut {
            self.toggle_slice();
        }
    }

    /// Copies what a report of a problem needs, and shows a notice.
    pub(super) fn report_problem(&self) {
        if let Some(host) = &self.host.script {
            host.copy_report(&self.said().join("\n"));
            self.say("page.report_copied");
        }
    }
}

//! The native window.

use crate::app::SauteApp;
use crate::desktop::{NAME, Surroundings};

impl SauteApp {
    /// Connects devices, and keeps the cook in the user's folder.
    pub(crate) fn settle_in(&mut self, around: Surroundings, _: &egui::Context) {
        let folder = eframe::storage_dir(NAME);
        self.session.hands.folder = folder.as_ref().map(|folder| folder.join("calibrations"));
        self.begin_hands(around.hands);
        if let Some(folder) = folder.filter(|_| around.keeps) {
            self.keep_cook_in(&folder.join("cook.saute"));
        }
    }

    /// A window has no address, and nothing to copy.
    pub(crate) fn copy_text(&self, _: &str) {}
}

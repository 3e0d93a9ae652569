//! Which scale of doneness the window goes by.

use std::sync::Arc;

use saute_kitchen::food::Scale;
use saute_picture::stage::fitting_piece;

use crate::app::SauteApp;

impl SauteApp {
    /// The scale that was chosen; where the data no longer knows it, the first.
    pub fn chosen_scale(&self) -> Option<&Arc<Scale>> {
        let library = &self.session.library;
        library.scale(&self.settings.scale).or_else(|| library.scales.first())
    }

    /// The chosen scale of doneness, where it says anything about the food.
    pub fn scale(&self) -> Option<Arc<Scale>> {
        fitting_piece(self.session.steak(), self.chosen_scale()?)
    }

    pub(crate) fn choose_scale(&mut self, scale: &Scale) {
        self.settings.scale.clone_from(&scale.id);
        let key = if self.scale().is_some() { "notice.scale" } else { "notice.scale_meat" };
        let l = self.settings.language;
        self.notice.say(l.fill(key, &[("scale", &l.called("scale", &scale.name))]));
    }

    pub(crate) fn next_scale(&mut self) {
        let scales = &self.session.library.scales;
        let now = scales.iter().position(|s| s.id == self.settings.scale).unwrap_or(0);
        if let Some(next) = scales.get((now + 1) % scales.len().max(1)).cloned() {
            self.choose_scale(&next);
        }
    }
}

//! The choice of a scale of doneness.

use std::sync::Arc;

use saute_kitchen::food::Scale;

use crate::app::SauteApp;

impl SauteApp {
    /// The chosen scale of doneness, where it says anything about the food.
    pub fn scale(&self) -> Option<Arc<Scale>> {
        self.session.scale(&self.settings.scale)
    }

    /// Selects a scale of doneness, with a notice.
    pub(crate) fn choose_scale(&mut self, scale: &Scale) {
        self.settings.scale.clone_from(&scale.id);
        let key = if self.scale().is_some() { "notice.scale" } else { "notice.scale_meat" };
        let l = self.settings.language;
        self.notice.say(l.fill(key, &[("scale", &l.called("scale", &scale.name))]));
    }

    /// Selects the next scale of doneness.
    pub(crate) fn next_scale(&mut self) {
        let scales = &self.session.library.scales;
        let now = scales.iter().position(|s| s.id == self.settings.scale).unwrap_or(0);
        if let Some(next) = scales.get((now + 1) % scales.len().max(1)).cloned() {
            self.choose_scale(&next);
        }
    }
}

//! The choice of a scale of doneness.

use crate::app::SauteApp;
use saute_kitchen::food::Scale;
use saute_words::doneness_words;
use std::sync::Arc;

impl SauteApp {
    /// The scale of doneness in whose words the panels describe the food that they show.
    pub fn scale(&self) -> Option<Arc<Scale>> {
        self.session.scale(&self.settings.scale)
    }

    /// Selects a scale of doneness, with a notice; of a food that has one scale only, the notice states which.
    pub(crate) fn choose_scale(&mut self, scale: &Scale) {
        let l = self.settings.language;
        let spoken = match self.scale() {
            Some(own) if self.session.fitting_scales().len() == 1 => own,
            _ => {
                self.settings.scale.clone_from(&scale.id);
                self.scale().unwrap_or_else(|| Arc::new(scale.clone()))
            }
        };
        let key = if self.settings.scale == spoken.id { "notice.scale" } else { "notice.scale_own" };
        self.desk.notice.say(l.fill(key, &[("scale", &doneness_words::label(&spoken, l))]));
    }

    /// Selects the next of the scales of doneness that fit the food.
    pub(crate) fn next_scale(&mut self) {
        let scales = self.session.fitting_scales();
        let shown = self.scale();
        let now = scales.iter().position(|s| shown.as_ref().is_some_and(|shown| shown.id == s.id)).unwrap_or(0);
        if let Some(next) = scales.get((now + 1) % scales.len().max(1)) {
            self.choose_scale(next);
        }
    }
}

//! The chosen rendering quality: a level, or automatic.

use crate::app::SauteApp;
use saute_controls::settings::quality_choice::QualityChoice;
use saute_scene::quality::Quality;

impl SauteApp {
    /// The quality at which the scene is drawn now.
    pub fn quality(&self) -> Quality {
        match self.settings.quality {
            QualityChoice::Always(quality) => quality,
            QualityChoice::Automatic if self.software() => Quality::Quick,
            QualityChoice::Automatic => self.graphics.governor.level(),
        }
    }

    /// Chooses the quality of the picture.
    pub fn set_quality(&mut self, choice: QualityChoice) {
        self.settings.quality = choice;
    }
}

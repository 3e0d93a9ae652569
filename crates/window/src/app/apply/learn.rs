//! Skill mode: read-outs that are hidden, and why.

use saute_picture::View;

use crate::app::SauteApp;
use saute_controls::act::Act;

impl SauteApp {
    /// Hides all read-outs, or shows them again.
    pub(super) fn set_skill_mode(&mut self, on: bool) {
        self.settings.skill_mode = on;
        if on {
            (self.settings.view, self.settings.split, self.sights.slice) = (View::Look, false, None);
            (self.settings.curves_open, self.settings.pieces_open) = (false, false);
            self.sights.scene.placing = false;
            if self.shows_ways() {
                self.toggle_ways();
            }
        }
    }

    /// Returns true if an act would show what skill mode hides; shows a notice then.
    pub(super) fn is_hidden(&self, act: &Act) -> bool {
        let is_hidden = self.settings.skill_mode && act.traits().reads;
        if is_hidden {
            self.say("skill.off");
        }
        is_hidden
    }
}

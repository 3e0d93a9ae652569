//! The files of a cook: writing them, and the notices about them.

use std::path::Path;

use saute_session::export::Export;

use crate::app::SauteApp;

/// Keys of the notices once a cook is saved, or cannot be.
pub(crate) const COOK_SAID: [&str; 2] = ["notice.cook_saved", "notice.cook_not_saved"];

impl SauteApp {
    /// Writes the file of the cook by `write`, if there is one, and shows by the keys of both where it is or why it is not.
    pub(crate) fn export_by(
        &self,
        what: Export,
        path: &Path,
        said: [&'static str; 2],
        write: impl FnOnce(&[u8]) -> Result<(), String>,
    ) {
        let l = self.settings.language;
        let (bytes, leaves_out) = match self.session.exported(what) {
            Ok(made) => made,
            Err(error) => return self.desk.notice.say(l.fill("notice.no_recipe", &[("error", &error)])),
        };
        if self.say_written(path, write(&bytes), said) && leaves_out {
            self.say("notice.recipe_leaves_out");
        }
    }

    /// Shows that a file was written, or why not, by the keys of both; returns true if it was.
    pub(crate) fn say_written(
        &self,
        path: &Path,
        written: Result<(), String>,
        [done, not_done]: [&'static str; 2],
    ) -> bool {
        let l = self.settings.language;
        if let Err(error) = &written {
            let parts: [(&str, &dyn std::fmt::Display); 2] = [("path", &path.display()), ("error", error)];
            self.desk.notice.say(l.fill(not_done, &parts));
            return false;
        }
        self.desk.notice.say_of(l.fill(done, &[("path", &path.display())]), path.to_owned());
        true
    }
}

//! Sessions from files.

use std::fmt::Display;

use saute_recipe::Recording;
use saute_recipe::session::Opened;

use super::SauteApp;
use super::keeps::later::Later;

impl SauteApp {
    /// Opens a session's file: it is played again up to its end. Reports what of it was lost, or why it cannot be opened.
    pub(crate) fn open_session(&mut self, name: &str, bytes: &[u8]) {
        let l = self.settings.language;
        let Opened { recording, damage } = match Recording::from_file(bytes) {
            Ok(opened) => opened,
            Err(error) => return self.say_trouble(&error),
        };
        let is_to_build = self.session.builds_recorded_first(&recording);
        if self.waits_for_food(is_to_build, || Later::Session(name.to_owned(), bytes.to_vec())) {
            return;
        }
        if let Err(error) = self.session.resume(recording) {
            return self.say_trouble(&error);
        }
        let file: (&str, &dyn Display) = ("file", &name);
        self.desk.notice.say(match damage {
            Some(damage) if damage.is_beyond => l.fill("notice.session_longer", &[file]),
            Some(_) => l.fill("notice.session_damaged", &[file]),
            None => l.fill("notice.session_opened", &[file]),
        });
    }
}

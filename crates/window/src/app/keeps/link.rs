//! A cook as the fragment of an address: what it began with and every command, packed, with a version and a checksum.

use crate::app::SauteApp;
use crate::app::keeps::later::Later;
use crate::host::Host;
use crate::system::page_address;
use saute_recipe::Recording;
use saute_session::kept::link::{LONGEST, fragment, read};
use saute_session::permits::Permit;

impl SauteApp {
    /// Copies an address that contains the cook, and states how long it is; one that is too long to be sent is not copied.
    pub(crate) fn copy_link(&mut self, ctx: &egui::Context) {
        let Some(address) = page_address() else { return };
        let link = format!("{address}#{}", fragment(&self.session.whole_recording()));
        let (l, length) = (self.settings.language, link.len());
        if length > LONGEST {
            return self.desk.notice.say(l.fill("link.too_long", &[("length", &length), ("most", &LONGEST)]));
        }
        self.host.copy_text(&link, ctx);
        self.desk.notice.say(l.fill("link.copied", &[("length", &length)]));
    }

    /// Opens the cook that a fragment contains; nothing if it is about something else.
    pub fn open_link(&mut self, fragment: &str) {
        if !self.permits().allow(&[Permit::Leaving]) {
            return;
        }
        match read(fragment) {
            Ok(None) => {}
            Ok(Some(recording)) => self.open_linked(recording, fragment),
            Err(error) => self.say(error.words()),
        }
    }

    fn open_linked(&mut self, recording: Recording, fragment: &str) {
        let is_to_build = self.session.builds_recorded_first(&recording);
        if self.waits_for_food(is_to_build, || Later::Link(fragment.to_owned())) {
            return;
        }
        match self.session.resume(recording) {
            Ok(()) => self.say("link.opened"),
            Err(error) => self.say_trouble(&error),
        }
    }
}

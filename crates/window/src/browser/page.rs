//! What the window has of its page.

use std::path::PathBuf;

use saute_haptics::Rumble;
use saute_scene::light::photo::Photo;
use saute_study::class::ResultRow;

use super::host::Host as Script;
use super::{Inbox, Mirrored, download, gamepad};
use crate::host::{Host, PictureKeeper};
use crate::listener::Listener;
use saute_controls::input::gamepad::PadState;

/// Name of a downloaded picture; browsers number further ones.
const PICTURE: &str = "saute.png";

/// What the window has of its page.
#[derive(Default)]
pub struct Page {
    /// What the page hands in.
    pub(crate) inbox: Inbox,
    /// What the page's script does for the window.
    pub(crate) script: Option<Script>,
    /// The version of its build.
    pub(crate) version: String,
    /// The panels a second time, as HTML.
    pub(crate) mirrored: Mirrored,
}

impl Page {
    /// Returns true if the page can read how the phone is held.
    pub(crate) fn can_tilt(&self) -> bool {
        self.script.as_ref().is_some_and(Script::can_tilt)
    }
}

impl Host for Page {
    fn read_pad(&mut self) -> Option<PadState> {
        self.script.as_ref().and_then(gamepad::read)
    }

    fn turn_motors(&mut self, rumble: &Rumble) {
        if let Some(script) = &self.script {
            gamepad::shake(script, rumble);
        }
    }

    /// The script plays it from the start.
    fn speaker(&mut self) -> Option<Result<Box<dyn Listener>, String>> {
        None
    }

    fn picture_keeper(&self) -> PictureKeeper {
        Box::new(|bytes| download(PICTURE, "image/png", bytes).map(|()| PathBuf::from(PICTURE)))
    }

    fn save_table(&self, name: &str, csv: &str) -> Result<Option<PathBuf>, String> {
        download(name, "text/csv", csv.as_bytes()).map(|()| None)
    }

    /// A page has no photo mode.
    fn photo(&self) -> Option<Photo> {
        None
    }

    fn close_photo(&mut self) {}

    fn report(&self, row: &ResultRow) {
        if let Some(script) = &self.script {
            script.report(row);
        }
    }

    fn copy_text(&self, text: &str, ctx: &egui::Context) {
        match &self.script {
            Some(script) => script.copy_text(text),
            None => ctx.copy_text(text.to_owned()),
        }
    }
}

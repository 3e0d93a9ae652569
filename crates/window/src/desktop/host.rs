//! What the window has of the desktop.

use std::path::PathBuf;

use saute_haptics::Rumble;
use saute_scene::light::photo::Photo;
use saute_study::class::ResultRow;

use super::files::{Dialog, pictures_folder, write_picture};
use super::photo::PhotoMode;
use crate::host::{Host, PictureKeeper};
use crate::listener::Listener;
use saute_controls::hands::GamepadDevice;
use saute_controls::input::gamepad::PadState;

/// What the window has of the desktop.
#[derive(Default)]
pub struct Desktop {
    /// The folder of pictures, if it is not the user's.
    pub(crate) pictures: Option<PathBuf>,
    /// The file dialog while it is open.
    pub(crate) dialog: Dialog,
    /// The photo mode.
    pub(crate) photo: PhotoMode,
    /// True if the sound card may be used, and was not yet.
    pub(crate) may_sound: bool,
    pub(crate) pad: GamepadDevice,
}

impl Desktop {
    /// The folder into which pictures are saved.
    pub(crate) fn pictures_folder(&self) -> PathBuf {
        self.pictures.clone().unwrap_or_else(pictures_folder)
    }
}

impl Host for Desktop {
    fn read_pad(&mut self) -> Option<PadState> {
        self.pad.read()
    }

    fn turn_motors(&mut self, rumble: &Rumble) {
        self.pad.shake(rumble);
    }

    fn speaker(&mut self) -> Option<Result<Box<dyn Listener>, String>> {
        if !std::mem::take(&mut self.may_sound) {
            return None;
        }
        let opened = saute_speaker::Speaker::new(Box::new(saute_speaker::system));
        Some(opened.map(|speaker| Box::new(speaker) as Box<dyn Listener>).map_err(|trouble| trouble.to_string()))
    }

    fn picture_keeper(&self) -> PictureKeeper {
        let folder = self.pictures_folder();
        Box::new(move |bytes| write_picture(&folder, "png", bytes))
    }

    /// Into the folder of pictures, where people find what they save without a dialog.
    fn save_table(&self, name: &str, csv: &str) -> Result<Option<PathBuf>, String> {
        let path = self.pictures_folder().join(name);
        match saute_files::write_whole(&path, csv.as_bytes()) {
            Ok(()) => Ok(Some(path)),
            Err(error) => Err(format!("{}: {error}", path.display())),
        }
    }

    fn photo(&self) -> Option<Photo> {
        self.photo.open.then_some(self.photo.choice.photo)
    }

    fn close_photo(&mut self) {
        self.photo.open = false;
    }

    /// No page embeds a native window to receive results.
    fn report(&self, _: &ResultRow) {}

    fn copy_text(&self, text: &str, ctx: &egui::Context) {
        ctx.copy_text(text.to_owned());
    }
}

impl Listener for saute_speaker::Speaker {
    fn hear(&mut self, told: &saute_sound::Told, events: &[saute_sound::Event]) {
        Self::hear(self, *told, events);
    }

    fn trouble(&mut self) -> Option<String> {
        Self::trouble(self).map(|trouble| trouble.to_string())
    }
}

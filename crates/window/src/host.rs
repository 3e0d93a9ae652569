//! What the world around the window does for it: a system's desktop, or the page.

use std::path::PathBuf;

use saute_haptics::Rumble;
use saute_scene::light::photo::Photo;
use saute_study::class::ResultRow;

#[cfg(target_arch = "wasm32")]
pub use crate::browser::{host::PageStart as HostStart, page::Page as CurrentHost};
#[cfg(not(target_arch = "wasm32"))]
pub use crate::desktop::host::Desktop as CurrentHost;
use crate::listener::Listener;
#[cfg(not(target_arch = "wasm32"))]
pub use saute_controls::hands::HandsStart as HostStart;
use saute_controls::input::gamepad::PadState;

/// What writes a picture, on any thread; returns where it is then, or what it is called.
pub type PictureKeeper = Box<dyn Fn(&[u8]) -> Result<PathBuf, String> + Send>;

/// What a desktop and a page do for the window, each in its way.
pub trait Host {
    /// Returns what the first gamepad reads; none where none is plugged in.
    fn read_pad(&mut self) -> Option<PadState>;

    /// Lets the motors of the first gamepad turn so fast; nothing where it has none.
    fn turn_motors(&mut self, rumble: &Rumble);

    /// Returns the listener that plays what is heard, once, or why there is none; none where that is known, or no sound is requested.
    fn speaker(&mut self) -> Option<Result<Box<dyn Listener>, String>>;

    /// Returns what writes a picture.
    fn picture_keeper(&self) -> PictureKeeper;

    /// Saves a table; returns its path where it has one.
    ///
    /// # Errors
    ///
    /// Why it is not saved.
    fn save_table(&self, name: &str, csv: &str) -> Result<Option<PathBuf>, String>;

    /// Exposure and aperture of the photo mode; none while it is closed, or where there is none.
    fn photo(&self) -> Option<Photo>;

    /// Closes the photo mode.
    fn close_photo(&mut self);

    /// Hands a result of a lesson to whoever requested it.
    fn report(&self, row: &ResultRow);

    /// Copies a text to the clipboard; a page whose clipboard is closed shows it, to be copied by hand.
    fn copy_text(&self, text: &str, ctx: &egui::Context);
}

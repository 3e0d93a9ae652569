//! What the window draws with.

use saute_scene::quality::Quality;

use saute_picture::governor::Governor;

/// What the window draws with.
pub(crate) struct Graphics {
    /// True if the scene can be drawn (a graphics device is there).
    pub(crate) drawable: bool,
    pub(crate) software: bool,
    /// True if panels are drawn a few times a second only where the graphics are software.
    pub(crate) frugal: bool,
    /// Chooses the quality of the picture where that is left to the program.
    pub(crate) governor: Governor,
    /// True if there is a font with kana and kanji.
    pub(crate) japanese_font: bool,
}

impl Graphics {
    /// Before a context is known.
    pub(crate) fn new(frugal: bool, japanese_font: bool) -> Self {
        Self { drawable: false, software: false, frugal, governor: Governor::new(Quality::Best), japanese_font }
    }
}

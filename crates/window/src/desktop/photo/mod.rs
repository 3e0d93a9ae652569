//! Photo mode: exposure, blur and size of a picture without panels, and a time lapse of the cook.

pub(crate) mod making;

use self::making::Making;
use saute_controls::act::PhotoChoice;

/// State of the photo mode.
#[derive(Debug, Default)]
pub struct PhotoMode {
    /// True while it is open: no panel covers the scene, and time waits.
    pub open: bool,
    /// What the photographer has chosen.
    pub choice: PhotoChoice,
    pub(crate) making: Option<Making>,
}

impl PhotoMode {
    /// How much of a picture or a time lapse is done (0–1); none if none is made.
    pub fn progress(&self) -> Option<f32> {
        self.making.as_ref().map(Making::progress)
    }
}

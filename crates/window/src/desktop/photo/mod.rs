//! Photo mode: exposure, blur and size of a picture without panels, and a time lapse of the cook.

pub(crate) mod making;

use self::making::Making;
use saute_scene::light::photo::Photo;

/// Sizes of a photo [pixels].
pub const SIZES: [[u32; 2]; 3] = [[1280, 720], [1920, 1080], [3840, 2160]];

/// What the photographer has chosen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PhotoChoice {
    /// Exposure and aperture.
    pub photo: Photo,
    /// Size of the picture [pixels].
    pub size: [u32; 2],
}

impl Default for PhotoChoice {
    fn default() -> Self {
        Self { photo: Photo::default(), size: SIZES[1] }
    }
}

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

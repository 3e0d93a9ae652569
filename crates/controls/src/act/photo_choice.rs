//! What a photographer chooses.

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

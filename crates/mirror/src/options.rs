//! What is chosen of the mirror's picture.

use crate::stereo::Stereo;

/// Options of the mirror's picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MirrorOptions {
    /// Stereo mode.
    pub stereo: Stereo,
    /// From eye to eye [m].
    pub eye_distance: f64,
    /// True if the virtual pan is drawn.
    pub pan_shown: bool,
}

//! How a photographer sets the camera.

use std::ops::RangeInclusive;

/// Settings of the camera, relative to those that suit the kitchen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Photo {
    /// Exposure over the usual one [EV]: each 1 doubles the light.
    pub exposure_ev: f32,
    /// Width of the aperture over the usual one [-]: what is behind the food is blurred in proportion; at
    /// the lower levels what is behind the pan, once the eye rests.
    pub aperture: f32,
}

impl Photo {
    /// Exposures that can be set [EV] (chosen: the food can still be made out).
    pub const EXPOSURES_EV: RangeInclusive<f32> = -2.0..=2.0;
    /// Apertures that can be set [-] (chosen: from a picture that is sharp throughout to a soft background).
    pub const APERTURES: RangeInclusive<f32> = 0.0..=4.0;

    /// What radiances are multiplied by [-].
    pub(crate) fn gain(self) -> f32 {
        self.exposure_ev.exp2()
    }
}

impl Default for Photo {
    fn default() -> Self {
        Self { exposure_ev: 0.0, aperture: 1.0 }
    }
}

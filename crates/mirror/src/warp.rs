//! The warp: from the picture that the eye sees to the pixels of the device that shows it.

use glam::{DMat3, DVec2};

use crate::keystone::{homography, taken};
use crate::lens::Lens;

/// A keystone and a lens: places in the eye's picture (shares of its width and height) to pixels of the device.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Warp {
    /// The keystone: from places in the picture to pixels, before the lens.
    pub keystone: DMat3,
    /// The lens after it.
    pub lens: Lens,
}

impl Warp {
    /// The warp that shows four places of the picture at four pixels through a lens; none where three are on a line.
    pub fn through(places: [DVec2; 4], pixels: [DVec2; 4], lens: Lens) -> Option<Self> {
        let ideal = pixels.map(|pixel| lens.undistorted(pixel));
        homography(places, ideal).map(|keystone| Self { keystone, lens })
    }

    /// The same warp for a device with another count of pixels, such as a window smaller than its screen.
    pub fn scaled(&self, from: DVec2, to: DVec2) -> Self {
        if from == to {
            return *self;
        }
        let scale = to / from;
        // A lens is round on the device; a window of other proportions is taken to be as high as it.
        let lens = Lens { centre: self.lens.centre * scale, unit: self.lens.unit * scale.y, ..self.lens };
        Self { keystone: DMat3::from_diagonal(scale.extend(1.0)) * self.keystone, lens }
    }

    /// The pixel that shows a place of the picture.
    pub fn pixel(&self, place: DVec2) -> DVec2 {
        self.lens.distorted(taken(&self.keystone, place))
    }

    /// The place of the picture that a pixel shows [-].
    pub fn place(&self, pixel: DVec2) -> DVec2 {
        taken(&self.keystone.inverse(), self.lens.undistorted(pixel))
    }

    /// True where left and right change places on their way to the device, as for a screen before a mirror.
    pub fn flips(&self) -> bool {
        self.keystone.determinant() < 0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_pixel_shows_the_place_that_it_is_shown_at() {
        let size = DVec2::new(1920.0, 1080.0);
        let lens = Lens { k: [-0.07, 0.02], ..Lens::none(size) };
        let places = [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y];
        let pixels = [[1800.0, 40.0], [90.0, 80.0], [150.0, 1000.0], [1750.0, 1060.0]].map(DVec2::from_array);
        let warp = Warp::through(places, pixels, lens).expect("no three on a line");
        for (place, pixel) in places.into_iter().zip(pixels) {
            assert!(warp.pixel(place).distance(pixel) < 1e-6);
        }
        for place in [DVec2::new(0.2, 0.9), DVec2::new(0.5, 0.5)] {
            assert!(warp.place(warp.pixel(place)).distance(place) < 1e-9);
        }
        assert!(warp.flips());
    }
}

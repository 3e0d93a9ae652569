//! A lens: the radial distortion of Brown and Conrady with two coefficients.

use glam::DVec2;

/// Radial distortion: a point at the distance r from the centre is moved to r (1 + k₁ r² + k₂ r⁴).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lens {
    /// First and second coefficient, for distances in `unit` [-].
    pub k: [f64; 2],
    /// Point that is not moved [pixels].
    pub centre: DVec2,
    /// Length in which distances are counted [pixels].
    pub unit: f64,
}

/// Steps of Newton's method (chosen: the shader takes as many; after five no distance of a real lens changes any more).
pub const NEWTON_STEPS: usize = 6;

impl Lens {
    /// A lens without distortion, for a picture of a size [pixels].
    pub fn none(size: DVec2) -> Self {
        Self { k: [0.0; 2], centre: 0.5 * size, unit: 0.5 * size.length() }
    }

    /// Where a lens moves a point [pixels].
    pub fn distorted(&self, ideal: DVec2) -> DVec2 {
        let from = (ideal - self.centre) / self.unit;
        let r2 = from.length_squared();
        self.centre + self.unit * from * (1.0 + r2 * (self.k[0] + r2 * self.k[1]))
    }

    /// The point that a lens moves to a place [pixels].
    pub fn undistorted(&self, moved: DVec2) -> DVec2 {
        let from = (moved - self.centre) / self.unit;
        let distance = from.length();
        if distance < 1e-12 {
            return moved;
        }
        let [k1, k2] = self.k;
        let mut r = distance;
        for _ in 0..NEWTON_STEPS {
            let r2 = r * r;
            let slope = 1.0 + r2 * (3.0 * k1 + 5.0 * k2 * r2);
            r -= (r * (1.0 + r2 * (k1 + r2 * k2)) - distance) / slope.max(0.1);
        }
        self.centre + self.unit * from * (r / distance)
    }

    /// The same lens with distances counted in another unit [pixels].
    pub fn in_unit(self, unit: f64) -> Self {
        let scale = (unit / self.unit).powi(2);
        Self { k: [self.k[0] * scale, self.k[1] * scale * scale], unit, ..self }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_lens_has_moved_is_found_again() {
        for k in [[-0.08, 0.02], [0.1, 0.0], [-0.05, -0.02], [0.0, 0.0]] {
            let lens = Lens { k, centre: DVec2::new(900.0, 700.0), unit: 1101.0 };
            for point in [DVec2::ZERO, DVec2::new(1920.0, 0.0), DVec2::new(40.0, 1080.0), lens.centre] {
                assert!(lens.undistorted(lens.distorted(point)).distance(point) < 1e-6, "{k:?} {point}");
            }
        }
    }

    #[test]
    fn the_unit_of_length_does_not_matter() {
        let lens = Lens { k: [-0.08, 0.03], centre: DVec2::new(900.0, 500.0), unit: 2700.0 };
        let point = DVec2::new(100.0, 80.0);
        assert!(lens.in_unit(1101.0).distorted(point).distance(lens.distorted(point)) < 1e-9);
    }
}

//! Closed polygonal outlines of cross-sections.

use libm::{cos, fabs, pow, sin};

use crate::mesh::outline_bands::is_crossed;

/// A closed polygon, counter-clockwise, with its area centroid at the origin [m].
#[derive(Clone, Debug, PartialEq)]
pub struct Outline {
    /// Corners in order [m].
    pub points: Vec<[f64; 2]>,
}

/// Corners of a smooth outline before it is resampled [-] (chosen: chord error below 0.01 mm at 200 mm).
const FINE_CORNERS: usize = 1440;

impl Outline {
    /// Returns a superellipse with radial harmonics, of exactly `length` × `width` [m].
    ///
    /// |2x/length|ⁿ + |2y/width|ⁿ = 1, with the radius multiplied by 1 + Σ aₘ cos(m φ + φₘ) for `harmonics`
    /// `(m, aₘ, φₘ)`. n = 2 is an ellipse; a larger n is more rectangular. Convex for n ≥ 2 and small aₘ.
    pub fn superellipse(length: f64, width: f64, n: f64, harmonics: &[(u32, f64, f64)]) -> Self {
        let raw = (0..FINE_CORNERS).map(|i| {
            let angle = core::f64::consts::TAU * i as f64 / FINE_CORNERS as f64;
            let ripple: f64 = 1.0 + harmonics.iter().map(|&(m, a, p)| a * cos(f64::from(m) * angle + p)).sum::<f64>();
            let bulge = |v: f64| libm::copysign(pow(fabs(v), 2.0 / n), v);
            [ripple * bulge(cos(angle)), ripple * bulge(sin(angle))]
        });
        Self { points: raw.collect() }.scaled_to(length, width).centred()
    }

    /// Returns a circle of the given radius [m].
    pub fn circle(radius: f64) -> Self {
        Self::superellipse(2.0 * radius, 2.0 * radius, 2.0, &[])
    }

    /// Returns a rectangle of `length` along x and `width` along y [m].
    pub fn rectangle(length: f64, width: f64) -> Self {
        let (a, b) = (0.5 * length, 0.5 * width);
        Self { points: vec![[-a, -b], [a, -b], [a, b], [-a, b]] }
    }

    /// Returns a polygon of the given corners, stretched to `length` along x and `width` along y [m].
    pub fn polygon(corners: &[[f64; 2]], length: f64, width: f64) -> Self {
        Self { points: corners.to_vec() }.scaled_to(length, width).centred()
    }

    fn scaled_to(mut self, length: f64, width: f64) -> Self {
        for (axis, extent) in [(0, length), (1, width)] {
            let low = self.points.iter().map(|p| p[axis]).fold(f64::INFINITY, f64::min);
            let high = self.points.iter().map(|p| p[axis]).fold(f64::NEG_INFINITY, f64::max);
            self.points.iter_mut().for_each(|p| p[axis] = (p[axis] - low) / (high - low) * extent);
        }
        self
    }

    fn centred(mut self) -> Self {
        let [cx, cy] = self.centroid();
        self.points.iter_mut().for_each(|p| *p = [p[0] - cx, p[1] - cy]);
        self
    }

    /// Returns the enclosed area [m²].
    pub fn area(&self) -> f64 {
        self.corners().map(|(p, q)| 0.5 * (p[0] * q[1] - q[0] * p[1])).sum()
    }

    /// Returns the area centroid [m].
    pub fn centroid(&self) -> [f64; 2] {
        let mut moment = [0.0; 2];
        for (p, q) in self.corners() {
            let cross = (p[0] * q[1] - q[0] * p[1]) / 6.0;
            moment[0] += (p[0] + q[0]) * cross;
            moment[1] += (p[1] + q[1]) * cross;
        }
        let area = self.area();
        [moment[0] / area, moment[1] / area]
    }

    /// Returns the length of the closed curve [m].
    pub fn perimeter(&self) -> f64 {
        self.corners().map(|(p, q)| distance(p, q)).sum()
    }

    /// Returns the largest distance of a corner from the centroid [m].
    pub fn reach(&self) -> f64 {
        let centre = self.centroid();
        self.points.iter().map(|&p| distance(p, centre)).fold(0.0, f64::max)
    }

    /// Returns true if a point [m] is inside, by the even–odd rule.
    pub fn contains(&self, point: [f64; 2]) -> bool {
        self.corners().filter(|&(p, q)| is_crossed(point, [p, q])).count() % 2 == 1
    }

    /// Returns the distance of a point from the curve [m].
    pub fn distance_to(&self, point: [f64; 2]) -> f64 {
        self.corners().map(|(p, q)| distance_to_segment(point, p, q)).fold(f64::INFINITY, f64::min)
    }

    /// Returns points about `spacing` apart along the curve [m], each with the inward unit normal [-].
    ///
    /// A polygon of up to eight corners keeps its corners, and each side is divided evenly; a smooth outline is divided
    /// evenly as a whole.
    pub fn sampled(&self, spacing: f64) -> Vec<([f64; 2], [f64; 2])> {
        if self.points.len() <= 8 {
            return self.sampled_by_side(spacing);
        }
        self.evenly((libm::round(self.perimeter() / spacing) as usize).max(8))
    }

    /// Returns `count` evenly spaced points along the curve [m], each with the inward unit normal [-].
    pub fn evenly(&self, count: usize) -> Vec<([f64; 2], [f64; 2])> {
        let perimeter = self.perimeter();
        let mut samples = Vec::with_capacity(count);
        let (mut travelled, mut next) = (0.0, 0);
        for (p, q) in self.corners() {
            let length = distance(p, q);
            while next < count && (next as f64) * perimeter / (count as f64) <= travelled + length {
                let t = ((next as f64) * perimeter / (count as f64) - travelled) / length;
                let normal = [-(q[1] - p[1]) / length, (q[0] - p[0]) / length];
                samples.push(([p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])], normal));
                next += 1;
            }
            travelled += length;
        }
        samples
    }

    fn sampled_by_side(&self, spacing: f64) -> Vec<([f64; 2], [f64; 2])> {
        let mut samples = Vec::new();
        for (p, q) in self.corners() {
            let length = distance(p, q);
            let pieces = (libm::round(length / spacing) as usize).max(1);
            let normal = [-(q[1] - p[1]) / length, (q[0] - p[0]) / length];
            for i in 0..pieces {
                let t = i as f64 / pieces as f64;
                samples.push(([p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])], normal));
            }
        }
        samples
    }

    pub(super) fn corners(&self) -> impl Iterator<Item = ([f64; 2], [f64; 2])> + '_ {
        let n = self.points.len();
        (0..n).map(move |i| (self.points[i], self.points[(i + 1) % n]))
    }
}

fn distance(p: [f64; 2], q: [f64; 2]) -> f64 {
    libm::hypot(p[0] - q[0], p[1] - q[1])
}

pub(super) fn distance_to_segment(point: [f64; 2], p: [f64; 2], q: [f64; 2]) -> f64 {
    let d = [q[0] - p[0], q[1] - p[1]];
    let t = ((point[0] - p[0]) * d[0] + (point[1] - p[1]) * d[1]) / (d[0] * d[0] + d[1] * d[1]);
    let t = t.clamp(0.0, 1.0);
    distance(point, [p[0] + t * d[0], p[1] + t * d[1]])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn circle_has_its_area_and_perimeter() {
        let circle = Outline::circle(0.1);
        assert!((circle.area() / (core::f64::consts::PI * 0.01) - 1.0).abs() < 1e-4);
        assert!((circle.perimeter() / (core::f64::consts::TAU * 0.1) - 1.0).abs() < 1e-4);
    }

    #[test]
    fn rippled_outline_keeps_its_box_and_is_centred() {
        let steak = Outline::superellipse(0.12, 0.08, 2.6, &[(3, 0.02, 1.0), (2, 0.03, 0.4)]);
        let width = steak.points.iter().map(|p| p[1]).fold(f64::NEG_INFINITY, f64::max)
            - steak.points.iter().map(|p| p[1]).fold(f64::INFINITY, f64::min);
        assert!((width - 0.08).abs() < 1e-12);
        let [x, y] = steak.centroid();
        assert!(x.abs() < 1e-12 && y.abs() < 1e-12);
    }
}

//! The natural form of a slice: a seeded outline and thickness, with the volume of the plain slice.

use core::f64::consts::TAU;

use saute_heat::Outline;

use crate::description::NaturalForm;
use crate::tissue::noise::uniform;

/// Shares of the deviation of the outline in its waves 2, 3, … around the piece [-] (chosen: mostly two to four lobes; the
/// largest deviation of their sum is about the stated one).
const WAVES: [f64; 5] = [0.45, 0.42, 0.30, 0.20, 0.14];
/// Exponent of the dome's profile over the radius [-] (chosen: flat in the middle, so that the piece lies on it when it is
/// turned).
const DOME_EXPONENT: f64 = 4.0;
/// Half width of a crack at the rim [m] (chosen: two nodes of the section).
const CRACK: f64 = 7.5e-3;
/// Largest drop of a rim over the thickness [-] (chosen: a thin slice keeps an edge).
const LARGEST_DROP: f64 = 0.09;
/// Least number of cracks in a food that cracks [-], and the least depth over that of the deepest [-] (chosen).
const LEAST_CRACKS: u32 = 3;
const LEAST_CRACK: f64 = 0.35;

/// Seeded variation of one piece.
pub(crate) struct Variation<'a> {
    pub(crate) form: &'a NaturalForm,
    pub(crate) size: [f64; 3],
    pub(crate) seed: u64,
}

impl NaturalForm {
    /// How much lower the rim is than the face beyond the shoulder, over a thickness [-]; 0 without a shoulder.
    pub(crate) fn rim_drop(&self, thickness: f64) -> f64 {
        if self.shoulder_mm > 0.0 { (1e-3 * self.rim_thinner_mm / thickness).min(LARGEST_DROP) } else { 0.0 }
    }
}

impl Variation<'_> {
    /// Returns the natural outline of the piece; its polygon of nodes, `spacing` apart, has the area of the plain one's.
    pub(crate) fn outline(&self, plain: &Outline, spacing: f64) -> Outline {
        let area = |outline: &Outline| {
            Outline { points: outline.sampled(spacing).into_iter().map(|(p, _)| p).collect() }.area()
        };
        let mut outline = Outline { points: plain.points.iter().map(|p| self.moved(*p)).collect() };
        for _ in 0..2 {
            let scale = libm::sqrt(area(plain) / area(&outline));
            let [x, y] = outline.centroid();
            outline.points.iter_mut().for_each(|p| *p = [scale * (p[0] - x), scale * (p[1] - y)]);
        }
        outline
    }

    /// Where a point of the plain outline is in the natural one, before both have the same area [m].
    fn moved(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [a, b] = [0.5 * self.size[0], 0.5 * self.size[1]];
        let (u, v) = (x / a, y / b);
        let (form, sign) = (self.form, |index| self.signed(index));
        let out = 1.0 + self.wave(libm::atan2(v, u)) - self.crack(libm::atan2(y, x), a.min(b));
        let across = 1.0 + form.taper * sign(510) * u;
        let bend = form.bend * sign(511) * (u * u - 1.0 / 3.0);
        self.stretched([a * u * out, b * (v * out * across + bend)])
    }

    /// Returns a point stretched along a seeded axis and as much compressed across it [m].
    fn stretched(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let stretch = 1.0 + self.form.ellipse * (0.3 + 0.7 * self.share(512));
        let angle = TAU * self.share(513);
        let (sine, cosine) = (libm::sin(angle), libm::cos(angle));
        let (along, across) = ((cosine * x + sine * y) * stretch, (cosine * y - sine * x) / stretch);
        [cosine * along - sine * across, sine * along + cosine * across]
    }

    /// Deviation of the radius at an angle around the piece, relative to the radius [-].
    fn wave(&self, angle: f64) -> f64 {
        let one = |(k, share): (usize, &f64)| {
            let (order, index) = (k as f64 + 2.0, k as u64);
            let phase = TAU * self.share(530 + index);
            share * (0.5 + 0.5 * self.share(520 + index)) * libm::cos(order * angle + phase)
        };
        self.form.deviation * WAVES.iter().enumerate().map(one).sum::<f64>()
    }

    /// Depth of the cracks at an angle around the piece, relative to its radius [-].
    fn crack(&self, angle: f64, radius: f64) -> f64 {
        let most = self.form.cracks;
        if most == 0 {
            return 0.0;
        }
        let least = LEAST_CRACKS.min(most);
        let count = least + (f64::from(most - least + 1) * self.share(540)) as u32;
        let width = CRACK.min(0.5 * radius) / radius;
        let one = |k: u32| {
            let index = u64::from(k);
            let at = TAU * (f64::from(k) + 0.7 * (self.share(550 + index) - 0.5)) / f64::from(count);
            let apart = libm::remainder(angle - at, TAU) / width;
            let depth = LEAST_CRACK + (1.0 - LEAST_CRACK) * self.share(570 + index);
            depth * libm::pow((1.0 - libm::fabs(apart)).max(0.0), 1.5)
        };
        (1e-3 * self.form.crack_mm).min(0.15 * radius) / radius * (0..count).map(one).fold(0.0, f64::max)
    }

    /// Relative deviation of the thickness at a point of the section, up to a constant: a further wedge, and the dome [-].
    pub(crate) fn thickness(&self, [x, y]: [f64; 2]) -> f64 {
        let (u, v) = (x / self.size[0], y / self.size[1]);
        let angle = TAU * self.share(514);
        let slope = u * libm::cos(angle) + v * libm::sin(angle);
        let out = libm::pow(2.0 * libm::hypot(u, v), DOME_EXPONENT);
        self.form.wedge * (0.3 + 0.7 * self.share(515)) * slope - self.form.dome * out.min(1.5)
    }

    /// How much thinner the piece is where its shoulder falls to the rim, over the thickness [-]: a quarter of an ellipse
    /// over the distance from the outline.
    pub(crate) fn shoulder(&self, outline: &Outline, p: [f64; 2]) -> f64 {
        let width = 1e-3 * self.form.shoulder_mm;
        let drop = self.form.rim_drop(self.size[2]);
        if drop <= 0.0 {
            return 0.0;
        }
        let inwards = 1.0 - (outline.distance_to(p) / width).min(1.0);
        drop * (1.0 - libm::sqrt(1.0 - inwards * inwards))
    }

    /// Seeded number from 0 to 1 [-].
    pub(crate) fn share(&self, index: u64) -> f64 {
        uniform(self.seed, index)
    }

    /// Seeded number of either sign with a magnitude from 0.4 to 1 [-].
    pub(crate) fn signed(&self, index: u64) -> f64 {
        let share = 2.0 * self.share(index) - 1.0;
        libm::copysign(0.4 + 0.6 * libm::fabs(share), share)
    }
}

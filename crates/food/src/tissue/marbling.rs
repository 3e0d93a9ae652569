//! Where the fat seams run: along the ridges of one field.

use crate::description::Marbling;
use crate::tissue::noise::fractal;

/// Ridges along which seams of fat run [-].
#[derive(Clone, Debug)]
pub struct MarblingField {
    seed: u64,
    wavelength: f64,
    flattening: f64,
}

/// Width of the transition from lean to fat in units of the noise (chosen: seams about 1 mm wide with soft edges).
const EDGE: f64 = 0.10;

/// Flecks are this much finer than seams, this much thinner for their size, and join them over this much of the noise;
/// both come and go in patches of this strength (chosen by eye from photographs of graded striploin).
const FINER: f64 = 2.6;
const FINER_REACH: f64 = 1.15;
const JOIN: f64 = 0.12;
const PATCHY: f64 = 0.34;
/// Beyond all ridges, and halvings until their threshold is known to a thousandth of an edge.
const RIDGES: (f64, f64) = (-3.0, 3.0);
const BISECTIONS: usize = 16;

impl MarblingField {
    /// The ridges of a piece.
    pub fn new(marbling: &Marbling, seed: u64) -> Self {
        Self { seed, wavelength: marbling.seam_mm * 1e-3, flattening: marbling.flattening }
    }

    /// Ridged noise: large along thin, branching sheets that lie along x and through the thickness [-].
    pub fn ridge(&self, p: [f64; 3]) -> f64 {
        let w = self.wavelength;
        let q = [p[0] / (w * self.flattening), p[1] / w, p[2] / (w * self.flattening)];
        let bend = 0.9 * fractal(self.seed ^ 0xa5, [q[0] * 0.7, q[1] * 0.35, q[2] * 0.7]);
        let sheet = 1.0 - libm::fabs(fractal(self.seed, [q[0], q[1] + bend, q[2]])) * 2.2;
        let [x, y, z] = [FINER * q[0], FINER * (q[1] + 0.5 * bend), FINER * q[2]];
        let fleck = 1.0 - libm::fabs(fractal(self.seed ^ 0x3f, [x, y, z])) * 2.2 * FINER_REACH;
        let patch = PATCHY * fractal(self.seed ^ 0x77, [p[0] / (5.0 * w), p[1] / (4.0 * w), p[2] / (4.0 * w)]);
        // A smooth maximum: flecks branch off the seams.
        let h = (0.5 + 0.5 * (sheet - fleck) / JOIN).clamp(0.0, 1.0);
        fleck + h * (sheet - fleck) + JOIN * h * (1.0 - h) + patch
    }
}

/// The height of ridge above which flesh is fat, so that the mean share of adipose tissue over places with these ridges and
/// weights is the wanted one; by bisection [-].
pub fn threshold_for(wanted: f64, places: &[(f64, f64)]) -> f64 {
    let weight = places.iter().map(|place| place.1).sum::<f64>();
    let (mut low, mut high) = RIDGES;
    for _ in 0..BISECTIONS {
        let middle = 0.5 * (low + high);
        let fat = places.iter().map(|(ridge, weight)| weight * share_at(within(*ridge, middle))).sum::<f64>();
        if fat > wanted * weight { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

/// How far a ridge rises above a threshold, in widths of the seam's soft edge: [`share_at`] makes the share of it. It is
/// smoother than the share, so that a picture keeps its edges sharp between the samples [-].
pub fn within(ridge: f64, threshold: f64) -> f64 {
    (ridge - threshold) / EDGE
}

/// Share of adipose tissue so far within a seam: smooth from −½ to ½ [-].
pub fn share_at(within: f64) -> f64 {
    let s = (within + 0.5).clamp(0.0, 1.0);
    s * s * (3.0 - 2.0 * s)
}

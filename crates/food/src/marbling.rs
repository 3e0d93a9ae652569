//! Where the fat seams run: one field that both conducts and shows.

use crate::description::Marbling;
use crate::noise::fractal;

/// Share of adipose tissue at every point of a piece [-].
#[derive(Clone, Debug)]
pub struct MarblingField {
    seed: u64,
    wavelength: f64,
    flattening: f64,
    threshold: f64,
    share: f64,
}

/// Width of the transition from lean to fat in units of the noise (chosen: seams about 1 mm wide with soft edges).
const EDGE: f64 = 0.10;

/// Flecks are this much finer than seams, this much thinner for their size, and join them over this much of the noise;
/// both come and go in patches of this strength (chosen by eye from photographs of graded striploin).
const FINER: f64 = 2.6;
const FINER_REACH: f64 = 1.15;
const JOIN: f64 = 0.12;
const PATCHY: f64 = 0.34;

impl MarblingField {
    /// Seams where ridged noise exceeds the threshold that gives the wanted mean share; no seams without marbling.
    pub fn new(marbling: Option<&Marbling>, seed: u64) -> Self {
        let Some(marbling) = marbling else {
            return Self { seed, wavelength: 1.0, flattening: 1.0, threshold: 2.0, share: 0.0 };
        };
        let mut field = Self {
            seed,
            wavelength: marbling.seam_mm * 1e-3,
            flattening: marbling.flattening,
            threshold: 2.0,
            share: marbling.adipose_share,
        };
        if marbling.adipose_share > 0.0 {
            field.threshold = field.threshold_for(marbling.adipose_share);
        }
        field
    }

    /// Mean share asked for [-].
    pub fn mean_share(&self) -> f64 {
        self.share
    }

    /// Share of adipose tissue at a point of the rest frame [-].
    pub fn at(&self, p: [f64; 3]) -> f64 {
        share_at(self.within(p))
    }

    /// How far a point lies within a seam, in widths of the seam's soft edge: [`share_at`] makes the share of it. It is
    /// smoother than the share, so that a picture keeps its edges sharp between the samples [-].
    pub fn within(&self, p: [f64; 3]) -> f64 {
        if self.share <= 0.0 { f64::NEG_INFINITY } else { (self.ridge(p) - self.threshold) / EDGE }
    }

    /// Ridged noise: large along thin, branching sheets that lie along x and through the thickness.
    fn ridge(&self, p: [f64; 3]) -> f64 {
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

    /// The threshold whose mean share over a block of 12 × 12 × 6 seams is the wanted one, by bisection.
    fn threshold_for(&self, wanted: f64) -> f64 {
        let mut ridges = Vec::new();
        for i in 0..24 {
            for j in 0..24 {
                for k in 0..8 {
                    let at = |v: i32, n: f64| f64::from(v) / n - 0.5;
                    ridges.push(self.ridge([at(i, 24.0) * 0.12, at(j, 24.0) * 0.08, at(k, 8.0) * 0.025]));
                }
            }
        }
        let (mut low, mut high) = (-3.0, 3.0);
        for _ in 0..40 {
            let middle = 0.5 * (low + high);
            let mean = ridges.iter().map(|r| share_at((r - middle) / EDGE)).sum::<f64>() / ridges.len() as f64;
            if mean > wanted { low = middle } else { high = middle }
        }
        0.5 * (low + high)
    }
}

/// Share of adipose tissue so far within a seam: smooth from −½ to ½ [-].
pub fn share_at(within: f64) -> f64 {
    let s = (within + 0.5).clamp(0.0, 1.0);
    s * s * (3.0 - 2.0 * s)
}

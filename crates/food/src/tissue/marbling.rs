//! Fat seams along the ridges of a noise field.

use crate::description::Marbling;
use crate::tissue::noise::{Fractal, uniform};

/// Seeded ridged noise; seams of fat follow its ridges [-].
#[derive(Clone, Debug)]
pub struct MarblingField {
    bend: Fractal,
    sheet: Fractal,
    fleck: Fractal,
    patch: Fractal,
    wavelength: f64,
    flattening: f64,
    lean: f64,
}

/// Width of the transition from lean to fat in units of the noise [-] (chosen: seams about 1 mm wide with soft edges).
const EDGE: f64 = 0.10;

/// Frequency of the flecks relative to the seams [-] (chosen, as the next three, by eye from photographs of graded
/// striploin).
const FINER: f64 = 2.6;
/// Steepness of the flecks relative to the seams [-]: larger is thinner.
const FINER_REACH: f64 = 1.15;
/// Width of the smooth maximum by which flecks join seams, in units of the noise [-].
const JOIN: f64 = 0.12;
/// Amplitude of the patches in which seams and flecks come and go, in units of the noise [-].
const PATCHY: f64 = 0.34;
/// Range of the ridge heights [-], and number of bisections: the threshold is exact to a thousandth of an edge.
const RIDGES: (f64, f64) = (-3.0, 3.0);
const BISECTIONS: usize = 16;

/// Index of the draws of the lean, and its least share of the largest [-] (chosen: used by nothing else; no piece stands upright).
const LEANS: u64 = 630;
const LEAST_LEAN: f64 = 0.5;

impl MarblingField {
    /// The ridges of a piece with a seed.
    pub fn new(marbling: &Marbling, seed: u64) -> Self {
        let [bend, sheet, fleck, patch] = [0xa5, 0, 0x3f, 0x77].map(|stream| Fractal::new(seed ^ stream));
        let side = if uniform(seed, LEANS) < 0.5 { -1.0 } else { 1.0 };
        let lean = side * marbling.slant * (LEAST_LEAN + (1.0 - LEAST_LEAN) * uniform(seed, LEANS + 1));
        let (wavelength, flattening) = (marbling.seam_mm * 1e-3, marbling.flattening);
        Self { bend, sheet, fleck, patch, wavelength, flattening, lean }
    }

    /// Ridged noise: large along thin, branching sheets along x and through the thickness [-].
    pub fn ridge(&mut self, p: [f64; 3]) -> f64 {
        let w = self.wavelength;
        let q = [p[0] / (w * self.flattening), (p[1] + self.lean * p[2]) / w, p[2] / (w * self.flattening)];
        let bend = 0.9 * self.bend.at([q[0] * 0.7, q[1] * 0.35, q[2] * 0.7]);
        let sheet = 1.0 - libm::fabs(self.sheet.at([q[0], q[1] + bend, q[2]])) * 2.2;
        let [x, y, z] = [FINER * q[0], FINER * (q[1] + 0.5 * bend), FINER * q[2]];
        let fleck = 1.0 - libm::fabs(self.fleck.at([x, y, z])) * 2.2 * FINER_REACH;
        let patch = PATCHY * self.patch.at([p[0] / (5.0 * w), p[1] / (4.0 * w), p[2] / (4.0 * w)]);
        // Smooth maximum, so that flecks branch off the seams.
        let h = (0.5 + 0.5 * (sheet - fleck) / JOIN).clamp(0.0, 1.0);
        fleck + h * (sheet - fleck) + JOIN * h * (1.0 - h) + patch
    }
}

/// Returns the ridge height above which flesh is fat [-], by bisection.
///
/// With it the mean share of adipose tissue over `places`, given as (ridge, weight), is `wanted`.
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

/// Height of a ridge above a threshold, in widths of the seam's soft edge [-].
///
/// [`share_at`] converts it to the share of adipose tissue. It is smoother than that share, so that a picture keeps its edges
/// sharp between the samples.
pub fn within(ridge: f64, threshold: f64) -> f64 {
    (ridge - threshold) / EDGE
}

/// Share of adipose tissue at a depth within a seam: a smooth step from −½ to ½ [-].
pub fn share_at(within: f64) -> f64 {
    let s = (within + 0.5).clamp(0.0, 1.0);
    s * s * (3.0 - 2.0 * s)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn field(slant: f64, seed: u64) -> MarblingField {
        let food = r#"{ "adipose_share": 0.2, "seam_mm": 5.0, "flattening": 3.0, "slant": SLANT, "source": "test", "confidence": "low" }"#;
        let marbling: Marbling = serde_json::from_str(&food.replace("SLANT", &slant.to_string())).expect("a table");
        MarblingField::new(&marbling, seed)
    }

    /// Leaning moves seams aside with their height, and by no other way.
    #[test]
    fn seams_that_lean_are_the_upright_ones_sheared_within_what_is_stated() {
        let mut leans = Vec::new();
        for seed in 0..20 {
            let (mut upright, mut leaning) = (field(0.0, seed), field(0.9, seed));
            let lean = leaning.lean;
            assert!((0.45..=0.9).contains(&lean.abs()), "{lean}");
            leans.push(lean);
            for z in [-0.010, 0.0, 0.007] {
                let (x, y) = (0.013, -0.004);
                let q = [x, y + lean * z, z];
                let sheet = |field: &mut MarblingField, p: [f64; 3]| {
                    field.ridge(p) - PATCHY * field.patch.at(patch(p, field.wavelength))
                };
                let (seen, expected) = (sheet(&mut leaning, [x, y, z]), sheet(&mut upright, q));
                assert!((seen - expected).abs() < 1e-12, "{seen} {expected}");
            }
        }
        assert!(leans.iter().any(|lean| *lean > 0.0) && leans.iter().any(|lean| *lean < 0.0));
    }

    fn patch(p: [f64; 3], w: f64) -> [f64; 3] {
        [p[0] / (5.0 * w), p[1] / (4.0 * w), p[2] / (4.0 * w)]
    }
}

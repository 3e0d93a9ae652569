//! The fat cap of a steak: a strip of fat tissue along one of its long sides.

use core::f64::consts::PI;

use saute_heat::Outline;

use crate::description;
use crate::tissue::noise::{fractal, uniform};

/// Corners of the outline on which the cap lies [-] (chosen: 2 mm apart on a large steak).
const CORNERS: usize = 240;
/// Largest waviness of the inner border relative to the thickness [-], and its wavelength [m] (chosen by eye from photographs
/// of striploin).
const WAVE: f64 = 0.25;
const WAVELENGTH: f64 = 14.0e-3;
/// Width of a steak to which the stated thickness belongs [m] (chosen: the default; a smaller one has a thinner cap).
const STATED_FOR: f64 = 0.080;
/// Share of the cap at either end in which it tapers off [-] (chosen).
const TAPERS: f64 = 0.35;
/// Share of the cap at either end over which its border wanders, and by which it slants through the thickness [-] (chosen).
const ENDS: f64 = 0.045;
const SLANT: f64 = 0.07;
/// Distance beyond the cap from which nothing of it is left, in widths of its edge [-] (chosen: that of the seams' depth).
const FARTHEST: f64 = 4.0;

/// A seeded fat cap on an outline.
#[derive(Clone, Debug)]
pub(crate) struct FatCap {
    seed: u64,
    /// Thickness of the piece [m].
    thickness: f64,
    /// Width of the transition to the flesh [m].
    edge: f64,
    /// Corners of the outline along the cap, each with the cap's thickness there [m].
    along: Vec<([f64; 2], f64)>,
}

impl FatCap {
    /// The cap of a piece with an outline and a size [m].
    pub(crate) fn new(cap: &description::FatCap, outline: &Outline, size: [f64; 3], seed: u64) -> Self {
        let pick = |[low, high]: [f64; 2], index: u64| low + (high - low) * uniform(seed, index);
        let corners: Vec<[f64; 2]> = outline.evenly(CORNERS).into_iter().map(|(p, _)| p).collect();
        let thickness = 1e-3 * pick(cap.thickness_mm, 601) * (size[0].min(size[1]) / STATED_FOR).min(1.0);
        let count = (pick(cap.share, 602) * CORNERS as f64) as usize;
        // The middle of a long side, a little off.
        let side = if uniform(seed, 603) < 0.5 { -1.0 } else { 1.0 };
        let across = if size[0] >= size[1] { 1 } else { 0 };
        let off = 0.12 * (2.0 * uniform(seed, 604) - 1.0) * size[1 - across];
        let towards = |p: &[f64; 2]| side * p[across] - libm::fabs(p[1 - across] - off);
        let middle = (0..CORNERS).max_by(|a, b| towards(&corners[*a]).total_cmp(&towards(&corners[*b]))).unwrap_or(0);
        let corner = |k: usize| {
            let share = k as f64 / (count.max(2) - 1) as f64;
            let tapered = libm::sin(0.5 * PI * (share.min(1.0 - share) / TAPERS).min(1.0));
            (corners[(middle + CORNERS - count / 2 + k) % CORNERS], thickness * tapered)
        };
        Self { seed, thickness: size[2], edge: 1e-3 * cap.edge_mm, along: (0..count).map(corner).collect() }
    }

    /// Distance of a point of the section from the cap's side of the outline, the cap's thickness there [m], and the place
    /// along the cap from its end [-]; none far from it.
    pub(crate) fn near(&self, p: [f64; 2]) -> Option<NearCap> {
        let side = |(k, pair): (usize, &[([f64; 2], f64)])| {
            let ((a, thickness), (b, next)) = (pair[0], pair[1]);
            let way = [b[0] - a[0], b[1] - a[1]];
            let from = [p[0] - a[0], p[1] - a[1]];
            let share = (from[0] * way[0] + from[1] * way[1]) / (way[0] * way[0] + way[1] * way[1]);
            let share = share.clamp(0.0, 1.0);
            let away = libm::hypot(from[0] - share * way[0], from[1] - share * way[1]);
            let along = (k as f64 + share) / (self.along.len() - 1) as f64;
            NearCap { away, thickness: thickness + share * (next - thickness), along }
        };
        let sides = self.along.windows(2).enumerate().map(side);
        let near = sides.min_by(|a, b| a.away.total_cmp(&b.away))?;
        (near.away < near.thickness * (1.0 + 1.2 * WAVE) + FARTHEST * self.edge).then_some(near)
    }

    /// Depth of a point within the cap, in widths of its soft edge [-].
    pub(crate) fn within(&self, near: &NearCap, p: [f64; 3]) -> f64 {
        let wave = fractal(self.seed ^ 0xca_9fa7, p.map(|v| v / WAVELENGTH));
        let side = if near.along < 0.5 { 0 } else { 1 };
        let lean = SLANT * (2.0 * uniform(self.seed, 605 + side) - 1.0) * (2.0 * p[2] / self.thickness - 1.0);
        let wander = ENDS * fractal(self.seed ^ 0x0e_4d5, p.map(|v| v / WAVELENGTH));
        let end = near.along.min(1.0 - near.along) + wander + lean;
        let inside = (near.thickness * (1.0 + WAVE * wave) - near.away) / self.edge;
        // At its ends the cap runs out in an uneven line.
        inside.min((end - SLANT) / ENDS * FARTHEST)
    }
}

/// Where a point is near a cap.
#[derive(Clone, Copy, Debug)]
pub(crate) struct NearCap {
    away: f64,
    thickness: f64,
    along: f64,
}

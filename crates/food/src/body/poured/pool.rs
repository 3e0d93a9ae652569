//! How a poured food lies on the pan: its outline, the height of its white and the place of its yolk.

use libm::{atan2, cos, hypot, sin, sqrt};
use saute_heat::Outline;
use serde::{Deserialize, Serialize};

use crate::body::harmonics;
use crate::description::{FoodDescription, Pour, Yolk};
use crate::piece_spec::PieceSpec;

/// Directions in which the outline is known [-] (chosen: 13 mm apart on an egg of 130 mm).
pub const DIRECTIONS: usize = 32;
/// Shares of the reach at which the height is known, from the middle to the outline [-] (chosen: 9 mm apart).
pub const RINGS: usize = 8;
/// White below the yolk and above it [m] (chosen: fried eggs cut open have 1 to 2 mm below and a veil above).
const BELOW_YOLK: f64 = 1.0e-3;
const ABOVE_YOLK: f64 = 0.3e-3;
/// Least height of white [m] (chosen: thinner films tear).
const LEAST_HEIGHT: f64 = 0.5e-3;
/// Points between two directions of the drawn outline [-] (chosen: 3 mm apart).
const BETWEEN: usize = 4;

/// A yolk as it stands: half of an ellipsoid on a bed of white.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Serialize)]
pub struct Dome {
    /// Middle, from the middle of the piece [m].
    pub at: [f64; 2],
    /// Radius [m].
    pub radius: f64,
    /// Height [m].
    pub height: f64,
}

/// How a poured food lies, about the middle of what it wets.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Serialize)]
pub struct Pool {
    /// Distance of the outline from the middle, in directions evenly from +x on [m].
    pub reach: [f64; DIRECTIONS],
    /// Height of the white at even shares of the reach, the middle first, in every direction [m].
    pub height: [[f64; RINGS]; DIRECTIONS],
    /// The yolk.
    pub dome: Dome,
}

/// Reaches of a pool [m] (chosen: from a coat button to the largest pan).
const REACHES: core::ops::RangeInclusive<f64> = 5.0e-3..=0.25;
/// Heights of its white [m] (chosen: no pan is deeper).
pub const HEIGHTS: core::ops::RangeInclusive<f64> = 0.0..=0.08;
/// Radii of a yolk [m] (chosen: from a quail's egg cut small to an ostrich's).
const RADII: core::ops::RangeInclusive<f64> = 1.0e-3..=0.1;

impl Dome {
    /// Returns true if its numbers are those of a yolk in a pan.
    pub fn is_sound(&self) -> bool {
        let near = self.at.iter().all(|v| libm::fabs(*v) <= *REACHES.end());
        near && RADII.contains(&self.radius) && HEIGHTS.contains(&self.height) && self.height > 0.0
    }

    /// The yolk of a piece of a volume [m³], in its middle: V = 2/3 π r² h.
    pub fn of(yolk: &Yolk, volume: f64) -> Self {
        let height = 1e-3 * yolk.height_mm;
        let radius = sqrt(1.5 * yolk.share * volume / (core::f64::consts::PI * height));
        Self { at: [0.0; 2], radius, height }
    }

    /// Height of its top above the pan at a place [m]; none beside it.
    pub fn top(&self, [x, y]: [f64; 2]) -> Option<f64> {
        let out = hypot(x - self.at[0], y - self.at[1]) / self.radius;
        (out < 1.0).then(|| BELOW_YOLK + self.height * sqrt(1.0 - out * out))
    }

    /// Depth of a point below the skin of the yolk, about [m]; negative outside.
    pub fn depth(&self, [x, y, z]: [f64; 3]) -> f64 {
        let out = hypot(x - self.at[0], y - self.at[1]) / self.radius;
        let up = (z - BELOW_YOLK) / self.height;
        let inside = (1.0 - hypot(out, up.max(0.0))) * self.radius.min(self.height);
        inside.min(z - BELOW_YOLK)
    }
}

impl Pool {
    /// The piece as it lies on a level floor that sets it at once: a mound of thick white round the yolk, thin white about it.
    pub(crate) fn level(yolk: &Yolk, pour: &Pour, piece: &PieceSpec) -> Self {
        let radius = 0.25 * (piece.size[0] + piece.size[1]);
        let area = core::f64::consts::PI * radius * radius;
        let volume = area * piece.size[2];
        let dome = Dome::of(yolk, volume);
        let white = (1.0 - yolk.share) * volume;
        let [mound, edge] = [pour.thick_height_mm, pour.edge_mm].map(|mm| 1e-3 * mm);
        // The thick white and what of the yolk is in it fill a disc up to the height of the mound.
        let inner = sqrt((pour.thick_share * white / mound / core::f64::consts::PI) + dome.radius * dome.radius);
        let share = (inner / radius).min(0.9);
        let height = |ring: usize| {
            let out = ring as f64 / (RINGS - 1) as f64;
            let beyond = ((out - 0.8 * share) / (0.4 * share)).clamp(0.0, 1.0);
            mound + (edge - mound) * beyond * beyond * (3.0 - 2.0 * beyond)
        };
        let heights = core::array::from_fn(height);
        Self { reach: [radius; DIRECTIONS], height: [heights; DIRECTIONS], dome }
    }

    /// Returns true if its numbers are those of a pool in a pan.
    pub fn is_sound(&self) -> bool {
        self.reach.iter().all(|r| REACHES.contains(r))
            && self.height.iter().flatten().all(|h| HEIGHTS.contains(h))
            && self.dome.is_sound()
    }

    /// Largest area that it may have [m²].
    pub fn most_area(&self) -> f64 {
        let reach = self.reach.iter().copied().fold(0.0, f64::max);
        core::f64::consts::PI * reach * reach
    }

    /// The same with the tongues in which the rim of its seed runs out.
    pub(crate) fn wavy(mut self, description: &FoodDescription, piece: &PieceSpec) -> Self {
        let ripples = harmonics(description, piece);
        for (k, reach) in self.reach.iter_mut().enumerate() {
            *reach *= 1.0 + ripple(&ripples, core::f64::consts::TAU * k as f64 / DIRECTIONS as f64);
        }
        self
    }

    /// The outline, in the frame of the piece.
    pub(crate) fn outline(&self) -> Outline {
        let count = DIRECTIONS * BETWEEN;
        let point = |i: usize| {
            let angle = core::f64::consts::TAU * i as f64 / count as f64;
            let reach = self.reach_at(i as f64 / BETWEEN as f64);
            [reach * cos(angle), reach * sin(angle)]
        };
        Outline { points: (0..count).map(point).collect() }
    }

    /// Reach in a direction, in directions from +x [m]: smooth between four of them (Catmull and Rom's spline).
    fn reach_at(&self, direction: f64) -> f64 {
        let whole = libm::floor(direction);
        let t = direction - whole;
        let at = |k: i64| self.reach[(whole as i64 + k).rem_euclid(DIRECTIONS as i64) as usize];
        let [a, b, c, d] = [at(-1), at(0), at(1), at(2)];
        b + 0.5 * t * (c - a + t * (2.0 * a - 5.0 * b + 4.0 * c - d + t * (3.0 * (b - c) + d - a)))
    }

    /// Direction of a place, in directions from +x, and its share of the reach there [-].
    fn polar(&self, [x, y]: [f64; 2]) -> (f64, f64) {
        let turn = atan2(y, x) / core::f64::consts::TAU;
        let direction = (turn - libm::floor(turn)) * DIRECTIONS as f64;
        (direction, hypot(x, y) / self.reach_at(direction))
    }

    /// Height of the upper face above the pan at a place [m].
    pub fn height_at(&self, p: [f64; 2]) -> f64 {
        let white = self.white_at(p).max(LEAST_HEIGHT);
        self.dome.top(p).map_or(white, |top| white.max(top + ABOVE_YOLK))
    }

    /// Height of the white at a place, were there no yolk [m].
    fn white_at(&self, p: [f64; 2]) -> f64 {
        let (direction, share) = self.polar(p);
        let out = (share * (RINGS - 1) as f64).min((RINGS - 1) as f64 - 1e-9);
        let (k, ring) = (libm::floor(direction), libm::floor(out));
        let (s, t) = (direction - k, out - ring);
        let at = |k: usize, ring: usize| self.height[k % DIRECTIONS][ring];
        let along = |k: usize| at(k, ring as usize) + t * (at(k, ring as usize + 1) - at(k, ring as usize));
        along(k as usize) + s * (along(k as usize + 1) - along(k as usize))
    }

    /// Place in another pool of the same food that corresponds to a place in this one: as far out in the same direction [m].
    pub(crate) fn place_in(&self, other: &Self, p: [f64; 2]) -> [f64; 2] {
        let (direction, share) = self.polar(p);
        let angle = core::f64::consts::TAU * direction / DIRECTIONS as f64;
        let reach = share * other.reach_at(direction);
        [reach * cos(angle), reach * sin(angle)]
    }
}

/// Deviation of a wavy outline in a direction, relative to its radius [-].
fn ripple(ripples: &[(u32, f64, f64)], angle: f64) -> f64 {
    ripples.iter().map(|&(m, a, phase)| a * cos(f64::from(m) * angle + phase)).sum()
}

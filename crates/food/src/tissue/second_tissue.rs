//! The second tissue of a food: the core of a root, the green of a shaft's sheaths, or the yolk of an egg.

use crate::body::form::Form;
use crate::body::pool::{Dome, Pool};
use crate::description::{Core, FoodDescription, Sheaths};
use crate::tissue::node_means::Grown;
use crate::tissue::noise::{fractal, uniform};

/// Field of the second tissue: its share at every point of a piece, and the borders of its sheaths [-].
#[derive(Clone, Debug)]
pub struct TissueField {
    seed: u64,
    /// The two axes of the body frame across the direction of growth.
    across: [usize; 2],
    kind: Parts,
}

#[derive(Clone, Debug)]
enum Parts {
    Plain,
    Core {
        /// Mean radius [m], waviness of the edge [-] and width of the transition [m].
        radius: f64,
        wave: f64,
        edge: f64,
        /// Position of the core's axis [m].
        centre: [f64; 2],
    },
    Sheaths {
        /// Outer radius of each sheath, ascending [m].
        radii: Vec<f64>,
        /// Share of the second tissue in each sheath [-].
        shares: Vec<f64>,
        /// Conductance of the border between two sheaths [W/(m²·K)].
        conductance: f64,
    },
    Yolk(Dome),
}

/// Waviness of the sheaths' borders relative to their radius [-] (chosen: slightly out of round).
const SHEATH_WAVE: f64 = 0.04;

impl TissueField {
    /// The seeded field of a piece of the given size [m].
    pub(crate) fn new(description: &FoodDescription, size: [f64; 3], seed: u64, pool: Option<&Pool>) -> Self {
        let across = if description.form.grown_along() == 0 { [1, 2] } else { [0, 1] };
        let half = across.map(|axis| 0.5 * size[axis]);
        let radius = 0.5 * (half[0] + half[1]);
        let kind = match (&description.core, &description.sheaths, pool) {
            (Some(core), ..) => core_of(core, radius, half, seed),
            (None, Some(sheaths), _) => sheaths_of(sheaths, radius, seed),
            (None, None, Some(pool)) => Parts::Yolk(pool.dome),
            (None, None, None) => Parts::Plain,
        };
        Self { seed, across, kind }
    }

    /// Returns true if the piece has no second tissue.
    pub fn is_plain(&self) -> bool {
        matches!(self.kind, Parts::Plain)
    }

    /// Share of the second tissue at a point of the rest frame [-].
    pub fn at(&self, p: [f64; 3]) -> f64 {
        match &self.kind {
            Parts::Plain => 0.0,
            Parts::Core { radius, wave, edge, centre } => {
                let q = [p[self.across[0]] - centre[0], p[self.across[1]] - centre[1]];
                let reach = radius * (1.0 + wave * self.ripple(q));
                smooth_step((reach - libm::hypot(q[0], q[1])) / edge + 0.5)
            }
            Parts::Sheaths { shares, .. } => shares[self.sheath(p)],
            Parts::Yolk(dome) => f64::from(u8::from(dome.depth(p) > 0.0)),
        }
    }

    /// Index of the sheath around a point of the rest frame, from the middle outwards [-]; 0 without sheaths.
    pub fn sheath(&self, p: [f64; 3]) -> usize {
        let Parts::Sheaths { radii, .. } = &self.kind else { return 0 };
        let distance = self.off_axis(p);
        radii.partition_point(|r| *r < distance).min(radii.len() - 1)
    }

    /// Distance from the nearest border between sheaths or from the edge of a core [m]; infinite without either.
    pub fn border(&self, p: [f64; 3]) -> f64 {
        match &self.kind {
            Parts::Plain => f64::INFINITY,
            Parts::Core { radius, wave, centre, .. } => {
                let q = [p[self.across[0]] - centre[0], p[self.across[1]] - centre[1]];
                libm::fabs(radius * (1.0 + wave * self.ripple(q)) - libm::hypot(q[0], q[1]))
            }
            Parts::Sheaths { radii, .. } => {
                let distance = self.off_axis(p);
                radii.iter().map(|r| libm::fabs(r - distance)).fold(f64::INFINITY, f64::min)
            }
            Parts::Yolk(dome) => libm::fabs(dome.depth(p)),
        }
    }

    /// Radii of the borders between sheaths in a direction across the axis, from the middle outwards [m]; none without
    /// sheaths.
    pub fn sheath_borders(&self, towards: [f64; 2]) -> Vec<f64> {
        let Parts::Sheaths { radii, .. } = &self.kind else { return Vec::new() };
        let wave = 1.0 + SHEATH_WAVE * self.ripple(towards);
        radii.iter().map(|r| r * wave).collect()
    }

    /// Distance from the axis of growth, corrected for the waviness of the sheaths [m].
    fn off_axis(&self, p: [f64; 3]) -> f64 {
        let q = self.across.map(|axis| p[axis]);
        libm::hypot(q[0], q[1]) / (1.0 + SHEATH_WAVE * self.ripple(q))
    }

    /// Share of the conductance between two points that the borders between them leave [-].
    ///
    /// Each border is a contact resistance in series with flesh of the conductivity `k` [W/(m·K)].
    pub fn share_across(&self, [p, q]: [[f64; 3]; 2], k: f64) -> f64 {
        let Parts::Sheaths { conductance, .. } = &self.kind else { return 1.0 };
        let borders = self.sheath(p).abs_diff(self.sheath(q)) as f64;
        let length = libm::sqrt((0..3).map(|i| (p[i] - q[i]) * (p[i] - q[i])).sum());
        1.0 / (1.0 + borders * k / (conductance * length))
    }

    /// Periodic noise around the axis, about −1 to 1 [-].
    fn ripple(&self, [x, y]: [f64; 2]) -> f64 {
        let r = libm::hypot(x, y).max(1e-9);
        fractal(self.seed ^ 0x71_55ce, [1.9 * x / r, 1.9 * y / r, 0.5])
    }
}

fn core_of(core: &Core, radius: f64, half: [f64; 2], seed: u64) -> Parts {
    let angle = core::f64::consts::TAU * uniform(seed, 401);
    let far = core.offset * (0.4 + 0.6 * uniform(seed, 402));
    Parts::Core {
        radius: core.radius * radius,
        wave: core.wave,
        edge: 1e-3 * core.edge_mm,
        centre: [far * half[0] * libm::cos(angle), far * half[1] * libm::sin(angle)],
    }
}

/// Sheaths of seeded thickness out to the skin. The outer ones are greener, more so in a slice from higher up the shaft.
fn sheaths_of(sheaths: &Sheaths, radius: f64, seed: u64) -> Parts {
    let height = uniform(seed, 410);
    let (mut radii, mut shares) = (Vec::new(), Vec::new());
    let mut outer = 0.0;
    while outer < 1.15 * radius {
        let index = radii.len() as u64;
        let varied = 1.0 + sheaths.variation * (2.0 * uniform(seed, 420 + index) - 1.0);
        outer += 1e-3 * sheaths.thickness_mm * varied;
        let outwards = (outer / radius).min(1.0);
        let jitter = 0.15 * (uniform(seed, 470 + index) - 0.5);
        radii.push(outer);
        shares.push((sheaths.greenest * (1.5 * height + 0.9 * outwards - 0.9) + jitter).clamp(0.0, 1.0));
    }
    Parts::Sheaths { radii, shares, conductance: sheaths.conductance_w_m2k }
}

fn smooth_step(x: f64) -> f64 {
    let s = x.clamp(0.0, 1.0);
    s * s * (3.0 - 2.0 * s)
}

impl Grown for TissueField {
    fn at(&self, p: [f64; 3]) -> f64 {
        Self::at(self, p)
    }

    fn even(&self, _: [f64; 3], _: [f64; 3]) -> Option<f64> {
        None
    }
}

impl Form {
    /// Returns true if a piece of this form can have a second tissue.
    pub fn may_hold_tissues(self) -> bool {
        !matches!(self, Self::Shrimp | Self::Mesh | Self::Poured)
    }
}

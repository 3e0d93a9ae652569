//! Rendering: melting and release of fat.

use saute_heat::BodyMesh;

use crate::ZERO_C;
use crate::description::{FatMelting, FatRelease};
use crate::model::FoodModel;
use crate::state::FoodState;
use crate::table::Table;
use crate::water::juice::Runoff;

/// Rates of the release of molten fat.
#[derive(Clone, Debug)]
pub struct FatRates {
    /// Release rate of fat at a face against temperature [1/s].
    rate: Table,
    /// Temperature up to which no fat is released [K].
    solid_until: f64,
    /// Factor of the rate by the depth of each node below the nearest face [-].
    near: Vec<f64>,
    fine_share: f64,
    seam_share: f64,
}

impl FatRates {
    /// Tabulates the release rate times the molten share, and the depth factor of every node.
    pub fn new(release: &FatRelease, melting: &FatMelting, mesh: &BodyMesh) -> Self {
        let molten = |c: f64| 1.0 / (1.0 + libm::exp(-(c - melting.middle_c) / melting.width_k));
        let rate = |t: f64| {
            let c = t - ZERO_C;
            crate::table::interpolate(&release.celsius, &release.rate_per_s, c) * molten(c)
        };
        let rate = Table::new(ZERO_C, ZERO_C + 120.0, 0.5, rate);
        Self {
            solid_until: rate.zero_until(),
            rate,
            near: mesh.depths().iter().map(|depth| nearness(*depth, release.depth_mm * 1e-3)).collect(),
            fine_share: release.fine_share,
            seam_share: release.seam_share,
        }
    }
}

/// Depth factor exp(−depth / scale) of a depth [m] below the nearer big face of a slice or below the skin [-].
fn nearness(depth: f64, scale: f64) -> f64 {
    libm::exp(-depth / scale)
}

impl FoodModel {
    /// Releases molten fat for `dt` [s] and returns the fat that ran off.
    ///
    /// dF/dt = −k(T) e^(−depth/d) (F − F_kept), first order and implicit. F_kept is the raw fat less the releasable share,
    /// which depends on the node's share of seams.
    pub fn release_fat(&self, state: &mut FoodState, dt: f64) -> Runoff {
        let rates = &self.water.fat_rates;
        let mut left = Runoff::default();
        for node in 0..state.fat.len() {
            if state.temperature[node] <= rates.solid_until {
                continue;
            }
            let rate = rates.rate.at(state.temperature[node]) * rates.near[node];
            if rate <= 0.0 {
                continue;
            }
            let releasable = rates.fine_share + (rates.seam_share - rates.fine_share) * self.tissue.adipose[node];
            let free = state.fat[node] - (1.0 - releasable) * self.tissue.initial_fat[node];
            let mass = free.max(0.0) * (1.0 - 1.0 / (1.0 + rate * dt));
            let enthalpy = mass * self.properties.fat_enthalpy(state.temperature[node]);
            state.fat[node] -= mass;
            state.enthalpy[node] -= enthalpy;
            left.mass += mass;
            left.enthalpy += enthalpy;
        }
        state.rendered += left.mass;
        left
    }
}

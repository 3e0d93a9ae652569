//! The wooden board below resting food: one-dimensional conduction into layers of wood.

use crate::data::room::BoardData;
use serde::{Deserialize, Serialize};

/// Number of layers that warm up within a long rest [-] (chosen: √(αt) is 12 mm in 15 minutes).
const LAYERS: usize = 6;

/// Temperatures of the wood under one piece [K].
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct Board {
    /// Layer temperatures from the surface down [K].
    pub layers: [f64; LAYERS],
}

impl Board {
    /// A board at room temperature [K].
    pub fn at(room: f64) -> Self {
        Self { layers: [room; LAYERS] }
    }

    /// Adds heat [J/m²] to the top layer and conducts for `dt` [s]; explicit Euler step.
    pub fn absorb(&mut self, data: &BoardData, heat: f64, dt: f64) {
        let exchange = data.conductivity_w_mk / (data.layer_mm * 1e-3) * dt / data.areal_capacity_j_m2k;
        let before = self.layers;
        self.layers[0] += heat / data.areal_capacity_j_m2k;
        for i in 1..LAYERS {
            let flow = exchange * (before[i - 1] - before[i]);
            self.layers[i - 1] -= flow;
            self.layers[i] += flow;
        }
    }
}

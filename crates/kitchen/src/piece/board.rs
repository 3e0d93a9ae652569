//! The board that food rests on: layers of wood below the food.

use crate::data::room::BoardData;

/// Layers that warm up within a long rest (chosen: √(αt) is 12 mm in 15 minutes).
const LAYERS: usize = 6;

/// Temperatures of the wood under one piece [K].
#[derive(Clone, Debug, PartialEq)]
pub struct Board {
    /// From the surface down.
    pub layers: [f64; LAYERS],
}

impl Board {
    /// A board at room temperature [K].
    pub fn at(room: f64) -> Self {
        Self { layers: [room; LAYERS] }
    }

    /// Takes up heat [J/m²] and conducts it downwards for `dt` [s].
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

//! Load of the foods on the pan's nodes in one tick.

use saute_heat::Located;
use serde::{Deserialize, Serialize};

/// Sums over all foods at each node of the pan.
#[derive(Clone, Debug, Deserialize, Serialize)]
pub(crate) struct FoodLoad {
    /// Heat flow into food [W].
    pub(crate) heat: Vec<f64>,
    /// Share of the node's area under food [-].
    pub(crate) covered: Vec<f64>,
    /// Steam from food in this tick [kg].
    pub(crate) steam: Vec<f64>,
}

impl FoodLoad {
    /// No load on a number of nodes.
    pub(crate) fn none(nodes: usize) -> Self {
        Self { heat: vec![0.0; nodes], covered: vec![0.0; nodes], steam: vec![0.0; nodes] }
    }

    /// Divides the heat that a patch over `at` took in a tick of `dt` [s] among the nodes there [J].
    pub(crate) fn take(&mut self, at: &Located, heat: f64, dt: f64) {
        for (node, weight) in at.nodes.into_iter().zip(at.weights) {
            self.heat[node as usize] += weight * heat / dt;
        }
    }

    /// Covers the nodes at a patch of an area [m²], given the areas of all nodes [m²].
    pub(crate) fn cover(&mut self, at: &Located, area: f64, nodes: &[f64]) {
        for (node, weight) in at.nodes.into_iter().zip(at.weights) {
            self.covered[node as usize] += weight * area / nodes[node as usize];
        }
    }

    /// Clears the load at the start of a tick.
    pub(crate) fn clear(&mut self) {
        self.heat.fill(0.0);
        self.covered.fill(0.0);
        self.steam.fill(0.0);
    }
}

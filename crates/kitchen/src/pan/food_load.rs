//! Load of the foods on the pan's nodes in one tick.

/// Sums over all foods at each node of the pan.
#[derive(Clone, Debug)]
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

    /// Clears the load at the start of a tick.
    pub(crate) fn clear(&mut self) {
        self.heat.fill(0.0);
        self.covered.fill(0.0);
        self.steam.fill(0.0);
    }
}

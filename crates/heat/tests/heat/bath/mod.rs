//! Bodies of lumped nodes in surroundings of one temperature.

use saute_heat::{Conduction, Graph};

/// The thermal description of a body.
pub struct Bath<'a> {
    /// Volumes and edges.
    pub graph: &'a Graph,
    /// Conductances of the edges.
    pub conduction: &'a Conduction,
    /// Heat capacity of each node [J/K].
    pub capacity: &'a [f64],
    /// Conductance of each node to the surroundings [W/K].
    pub exchange: &'a [f64],
}

impl Bath<'_> {
    /// Advances the temperatures `t` by a time [s] with explicit steps; returns the absorbed heat [J].
    pub fn soak(&self, t: &mut [f64], ambient: f64, duration: f64) -> f64 {
        let limit = 0.9 * self.conduction.stable_step_with(self.capacity, self.exchange);
        let steps = (duration / limit).ceil();
        let dt = duration / steps;
        let mut taken = 0.0;
        let mut power = vec![0.0; t.len()];
        for _ in 0..steps as usize {
            for ((p, e), t) in power.iter_mut().zip(self.exchange).zip(t.iter()) {
                *p = e * (ambient - t);
                taken += *p * dt;
            }
            self.conduction.add_power(self.graph, t, &mut power);
            for ((t, p), c) in t.iter_mut().zip(&power).zip(self.capacity) {
                *t += p * dt / c;
            }
        }
        taken
    }
}

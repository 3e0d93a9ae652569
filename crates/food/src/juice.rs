//! Juice that the flesh no longer holds moves along the fibres to the two cut faces.

use crate::model::FoodModel;
use crate::state::FoodState;

/// Juice that ran off a piece.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Drip {
    /// Mass [kg].
    pub mass: f64,
    /// Its enthalpy above 0 °C [J].
    pub enthalpy: f64,
}

/// Juice on its way to a face.
#[derive(Clone, Copy, Default)]
struct Flow {
    mass: f64,
    enthalpy: f64,
}

impl FoodModel {
    /// Releases juice for `dt` [s] and returns what ran off.
    ///
    /// Water beyond what is held at the peak temperature leaves with first order. A source at depth z of a column
    /// with two open ends drains to each face in proportion to the opposite distance. On its way out it refills
    /// flesh that has dried below what it can hold; the rest gathers as a film on the face, then runs off.
    pub fn release_juice(&self, state: &mut FoodState, dt: f64) -> Drip {
        let released = 1.0 - 1.0 / (1.0 + self.water_holding.release_per_s * dt);
        let levels = self.mesh.levels.len();
        let mut drip = Drip::default();
        for i in 0..self.mesh.nodes_per_level() {
            let flows = self.column_release(state, i, released);
            for (flow, top) in [(flows[0], false), (flows[1], true)] {
                let left = self.refill(state, i, flow, top);
                let face = self.mesh.node(if top { levels - 1 } else { 0 }, i);
                self.settle(state, face, self.mesh.section.areas[i], left, &mut drip);
            }
        }
        state.dripped += drip.mass;
        drip
    }

    /// Water that a node can hold now [kg].
    fn capacity(&self, state: &FoodState, node: usize) -> f64 {
        self.initial_water[node] * self.held.at(state.peak[node])
    }

    /// Takes the released juice out of the inner nodes of a column; returns the flows to the bottom and to the top.
    fn column_release(&self, state: &mut FoodState, i: usize, released: f64) -> [Flow; 2] {
        let thickness = self.mesh.thickness();
        let mut flows = [Flow::default(); 2];
        for level in 1..self.mesh.levels.len() - 1 {
            let node = self.mesh.node(level, i);
            let surplus = state.water[node] - self.capacity(state, node);
            if surplus <= 0.0 {
                continue;
            }
            let mass = surplus * released;
            let enthalpy = mass * self.properties.water_enthalpy(state.temperature[node]);
            state.water[node] -= mass;
            state.enthalpy[node] -= enthalpy;
            let upwards = self.mesh.levels[level] / thickness;
            for (flow, share) in flows.iter_mut().zip([1.0 - upwards, upwards]) {
                flow.mass += mass * share;
                flow.enthalpy += enthalpy * share;
            }
        }
        flows
    }

    /// Refills dried nodes from mid-height outwards; returns what reaches the face.
    fn refill(&self, state: &mut FoodState, i: usize, mut flow: Flow, top: bool) -> Flow {
        let levels = self.mesh.levels.len();
        for step in 0..levels / 2 {
            if flow.mass <= 0.0 {
                break;
            }
            let level = if top { levels / 2 + 1 + step } else { levels / 2 - 1 - step };
            let node = self.mesh.node(level, i);
            let room = self.capacity(state, node) - state.water[node];
            if room > 0.0 {
                let share = (room / flow.mass).min(1.0);
                self.pour(state, node, &mut flow, share);
            }
        }
        flow
    }

    /// Lets juice gather on a face; what exceeds the film runs off.
    fn settle(&self, state: &mut FoodState, face: usize, area: f64, mut flow: Flow, drip: &mut Drip) {
        if flow.mass > 0.0 {
            self.pour(state, face, &mut flow, 1.0);
        }
        let most = self.capacity(state, face) + self.water_holding.film_kg_m2 * area;
        let excess = state.water[face] - most;
        if excess > 0.0 {
            let enthalpy = excess * self.properties.water_enthalpy(state.temperature[face]);
            state.water[face] -= excess;
            state.enthalpy[face] -= enthalpy;
            drip.mass += excess;
            drip.enthalpy += enthalpy;
        }
    }

    fn pour(&self, state: &mut FoodState, node: usize, flow: &mut Flow, share: f64) {
        let (mass, enthalpy) = (flow.mass * share, flow.enthalpy * share);
        state.water[node] += mass;
        state.enthalpy[node] += enthalpy;
        flow.mass -= mass;
        flow.enthalpy -= enthalpy;
        let masses = self.masses(node, state.water[node]);
        state.temperature[node] = self.properties.temperature(&masses, state.enthalpy[node], state.temperature[node]);
    }
}

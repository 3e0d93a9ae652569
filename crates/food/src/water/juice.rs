//! Juice that the flesh no longer holds moves along the fibres to the two cut faces.

use saute_heat::{BodyMesh, Layout, SweptMesh};

use crate::body::rest_shape::RestShape;
use crate::model::FoodModel;
use crate::state::FoodState;

/// Juice or fat that ran off a piece.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Runoff {
    /// Mass [kg].
    pub mass: f64,
    /// Its enthalpy above 0 °C [J].
    pub enthalpy: f64,
}

impl FoodModel {
    /// Releases and moves juice for `dt` [s] and returns what ran off.
    ///
    /// Water beyond what is held at the peak temperature and after the changes becomes free with first order. Free juice moves along the
    /// fibres towards the nearer face at a speed v: dF/dt = −F v/Δz, and takes its heat along. On its way flesh that
    /// has dried below what it can hold takes it up; what reaches a face gathers as a film there, then runs off. A body that
    /// is no slice has its fibres along it, and what its skin squeezes out runs off there; in a body of cells juice takes
    /// the shortest way to the skin.
    pub fn release_juice(&self, state: &mut FoodState, dt: f64) -> Runoff {
        let reach = 1e-6 * self.kinetics.water_holding.juice_speed_um_s * dt;
        let mut runoff = Runoff::default();
        match &self.shape.mesh {
            BodyMesh::Swept(mesh) => {
                for column in 0..mesh.nodes_per_level() {
                    (0..mesh.levels.len()).for_each(|level| self.free(state, mesh.node(level, column), dt));
                    self.drain(mesh, state, column, reach);
                }
            }
            BodyMesh::Cells(cells) => {
                (0..cells.node_count()).for_each(|node| self.free(state, node, dt));
                self.drain_cells(state, reach);
            }
        }
        for &(node, area) in &self.water.outlets {
            self.run_off(state, node as usize, area, &mut runoff);
        }
        state.dripped += runoff.mass;
        runoff
    }

    /// Juice that lies as a film on each node's face, over the most that stays there before it runs off [-]; 0 at nodes from
    /// which none runs off.
    pub fn juice_films(&self, state: &FoodState) -> Vec<f64> {
        let mut films = vec![0.0; state.juice.len()];
        for &(node, area) in &self.water.outlets {
            let most = self.kinetics.water_holding.film_kg_m2 * area;
            films[node as usize] = (state.juice[node as usize] / most).clamp(0.0, 1.0);
        }
        films
    }

    /// Water that a node can hold now [kg]: what the peak temperature leaves, or the changes if they leave less.
    fn capacity(&self, state: &FoodState, node: usize) -> f64 {
        let squeezed: f64 = state.changed.iter().zip(&self.water.squeeze).map(|(x, s)| s * x[node]).sum();
        self.tissue.initial_water[node] * self.water.held.at(state.peak[node]).min(1.0 - squeezed)
    }

    /// Frees a share of what a node no longer holds; dried flesh takes up free juice.
    fn free(&self, state: &mut FoodState, node: usize, dt: f64) {
        let surplus = (state.water[node] - self.capacity(state, node)).max(0.0);
        let bound = (surplus - state.juice[node]).max(0.0);
        let released = 1.0 - 1.0 / (1.0 + self.water.release.at(state.temperature[node]) * dt);
        state.juice[node] = (state.juice[node] + released * bound).min(surplus);
    }

    /// Moves free juice outwards from the middle level, half of whose juice goes either way; outer nodes come first, so
    /// that nothing moves by two nodes at once.
    fn drain(&self, mesh: &SweptMesh, state: &mut FoodState, column: usize, reach: f64) {
        let last = mesh.levels.len() - 1;
        if self.shape.closed_below {
            for to in (1..=last).rev() {
                let nodes = [to - 1, to].map(|level| mesh.node(level, column));
                self.carry(state, nodes, self.share(mesh, to - 1, to, reach));
            }
            return;
        }
        for to in 0..last.div_ceil(2) {
            for (from, to) in [(to + 1, to), (last - to - 1, last - to)] {
                let part = if 2 * from == last { 0.5 } else { 1.0 };
                let nodes = [from, to].map(|level| mesh.node(level, column));
                self.carry(state, nodes, part * self.share(mesh, from, to, reach));
            }
        }
    }

    /// Share of a level's free juice that passes to the next in the time in which it moves by `reach` [-]; none across
    /// a cut, where it gathers and runs off.
    fn share(&self, mesh: &SweptMesh, from: usize, to: usize, reach: f64) -> f64 {
        if self.shape.parts_levels(from, to) {
            return 0.0;
        }
        let spacing = libm::fabs(mesh.levels[from] - mesh.levels[to]);
        1.0 - 1.0 / (1.0 + reach / spacing)
    }

    /// Carries a share of a node's free juice to another with its heat.
    pub(crate) fn carry(&self, state: &mut FoodState, [from, to]: [usize; 2], share: f64) {
        let mass = share * state.juice[from];
        if mass <= 0.0 {
            return;
        }
        let enthalpy = mass * self.properties.water_enthalpy(state.temperature[from]);
        state.juice[from] -= mass;
        state.juice[to] += mass;
        for (node, sign) in [(from, -1.0), (to, 1.0)] {
            state.water[node] += sign * mass;
            state.enthalpy[node] += sign * enthalpy;
        }
    }

    /// Lets what exceeds the film on a face run off.
    fn run_off(&self, state: &mut FoodState, face: usize, area: f64, runoff: &mut Runoff) {
        let film = self.kinetics.water_holding.film_kg_m2 * area;
        let excess = (state.juice[face] - film).max(0.0);
        if excess > 0.0 {
            let enthalpy = excess * self.properties.water_enthalpy(state.temperature[face]);
            state.juice[face] -= excess;
            state.water[face] -= excess;
            state.enthalpy[face] -= enthalpy;
            runoff.mass += excess;
            runoff.enthalpy += enthalpy;
        }
    }
}

/// Nodes from which juice runs off, with their area [m²]: of a slice those of its cut faces, column by column; of other
/// bodies all of the skin.
pub(crate) fn juice_outlets(shape: &RestShape) -> Vec<(u32, f64)> {
    let Layout::Upright(mesh) = shape.mesh.layout() else {
        let mut areas = vec![0.0; shape.mesh.node_count()];
        shape.patches.iter().for_each(|p| areas[p.node as usize] += p.area);
        return (0u32..).zip(areas).filter(|(_, area)| *area > 0.0).collect();
    };
    let last = mesh.levels.len() - 1;
    let first = if shape.closed_below { last } else { 0 };
    let column = |i: usize| {
        let at = move |level: usize| (mesh.node(level, i) as u32, mesh.section.areas[i]);
        (first..=last).step_by(last).map(at)
    };
    (0..mesh.nodes_per_level()).flat_map(column).collect()
}

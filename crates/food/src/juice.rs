//! Juice that the flesh no longer holds moves along the fibres to the two cut faces.

use crate::model::FoodModel;
use crate::state::FoodState;

/// Nodes whose changes are added up at a time (chosen: they stay in the processor's nearest memory).
const BLOCK: usize = 64;

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
        self.free(state, dt);
        self.drain(state, reach);
        self.drain_cells(state, reach);
        for &(node, area) in &self.outlets {
            self.run_off(state, node as usize, area, &mut runoff);
        }
        state.dripped += runoff.mass;
        runoff
    }

    /// Nodes from which juice runs off, with their area [m²]: of a slice those of its cut faces, column by column; of
    /// other bodies all of the skin.
    pub(crate) fn juice_outlets(&self) -> Vec<(u32, f64)> {
        if !self.is_slice() {
            let mut areas = vec![0.0; self.mesh.node_count()];
            self.patches.iter().for_each(|p| areas[p.node as usize] += p.area);
            return (0u32..).zip(areas).filter(|(_, area)| *area > 0.0).collect();
        }
        let last = self.mesh.levels.len() - 1;
        let first = if self.closed_below { last } else { 0 };
        let column = |i: usize| {
            let at = move |level: usize| (self.mesh.node(level, i) as u32, self.mesh.section.areas[i]);
            (first..=last).step_by(last).map(at)
        };
        (0..self.mesh.nodes_per_level()).flat_map(column).collect()
    }

    /// Juice that lies as a film on each node's face, over the most that stays there before it runs off [-]; 0 at nodes from
    /// which none runs off.
    pub fn juice_films(&self, state: &FoodState) -> Vec<f64> {
        let mut films = vec![0.0; state.juice.len()];
        for &(node, area) in &self.outlets {
            let most = self.kinetics.water_holding.film_kg_m2 * area;
            films[node as usize] = (state.juice[node as usize] / most).clamp(0.0, 1.0);
        }
        films
    }

    /// Shares of the raw water that the changes squeeze out of the nodes from `first` on [-].
    fn squeezed(&self, state: &FoodState, first: usize) -> [f64; BLOCK] {
        let mut squeezed = [0.0; BLOCK];
        for (x, s) in state.changed.iter().zip(&self.squeeze) {
            squeezed.iter_mut().zip(&x[first..]).for_each(|(sum, x)| *sum += s * x);
        }
        squeezed
    }

    /// Frees a share of what nodes no longer hold; dried flesh takes up free juice.
    fn free(&self, state: &mut FoodState, dt: f64) {
        for first in (0..state.juice.len()).step_by(BLOCK) {
            let squeezed = self.squeezed(state, first);
            for (node, squeezed) in (first..state.juice.len()).zip(squeezed) {
                // A node can hold what the peak temperature leaves, or the changes if they leave less.
                let (held, unsqueezed) = (self.held.at(state.peak[node]), 1.0 - squeezed);
                let capacity = self.initial_water[node] * if held < unsqueezed { held } else { unsqueezed };
                let surplus = positive(state.water[node] - capacity);
                let juice = &mut state.juice[node];
                if surplus <= 0.0 && *juice >= 0.0 {
                    *juice = 0.0;
                    continue;
                }
                let bound = positive(surplus - *juice);
                let released = 1.0 - 1.0 / (1.0 + self.release.at(state.temperature[node]) * dt);
                let free = *juice + released * bound;
                *juice = if free < surplus { free } else { surplus };
            }
        }
    }

    /// Moves free juice outwards from the middle level, half of whose juice goes either way; outer nodes come first, so
    /// that nothing moves by two nodes at once.
    fn drain(&self, state: &mut FoodState, reach: f64) {
        let last = self.mesh.levels.len() - 1;
        if self.closed_below {
            for to in (1..=last).rev() {
                self.carry_level(state, [to - 1, to], self.share(to - 1, to, reach));
            }
            return;
        }
        for to in 0..last.div_ceil(2) {
            for (from, to) in [(to + 1, to), (last - to - 1, last - to)] {
                let part = if 2 * from == last { 0.5 } else { 1.0 };
                self.carry_level(state, [from, to], part * self.share(from, to, reach));
            }
        }
    }

    /// Carries a share of a level's free juice to another, in every column.
    fn carry_level(&self, state: &mut FoodState, levels: [usize; 2], share: f64) {
        for column in 0..self.mesh.nodes_per_level() {
            let nodes = levels.map(|level| self.mesh.node(level, column));
            if state.juice[nodes[0]] > 0.0 {
                self.carry(state, nodes, share);
            }
        }
    }

    /// Share of a level's free juice that passes to the next in the time in which it moves by `reach` [-]; none across
    /// a cut, where it gathers and runs off.
    fn share(&self, from: usize, to: usize, reach: f64) -> f64 {
        if self.parts_levels(from, to) {
            return 0.0;
        }
        let spacing = libm::fabs(self.mesh.levels[from] - self.mesh.levels[to]);
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

/// A mass, or none where it is negative.
#[inline]
fn positive(mass: f64) -> f64 {
    if mass > 0.0 { mass } else { 0.0 }
}

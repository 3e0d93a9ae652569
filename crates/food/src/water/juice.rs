//! Juice: release of water that the flesh no longer binds, and its run-off.

use core::ops::Range;

use saute_heat::{BodyMesh, Layout};

use crate::body::rest_shape::RestShape;
use crate::model::FoodModel;
use crate::state::FoodState;

/// Number of nodes in a block of the release [-] (chosen: a block stays in the processor's cache).
const BLOCK: usize = 64;

/// Mass and enthalpy of juice or fat that ran off a piece.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Runoff {
    /// Mass of the run-off [kg].
    pub mass: f64,
    /// Enthalpy of the run-off above 0 °C [J].
    pub enthalpy: f64,
}

impl FoodModel {
    /// Releases and moves juice for `dt` [s] and returns the juice that ran off.
    ///
    /// Water beyond the capacity of the flesh becomes free juice by a first-order rate. The capacity follows from the peak
    /// temperature and from the changes. Free juice moves along the fibres at a speed v, dF/dt = −F v/Δz, and carries its
    /// heat. Contraction drives it from hot flesh: most goes to the face on its own side of the coldest level, a part through
    /// that level to the other face. Where juice enters boiling flesh, a share passes to the face as liquid. Flesh that
    /// has dried below its capacity takes juice up. On a face juice forms a film; beyond the largest film it runs off. In a
    /// body along stations the fibres run along the path, and juice also runs off the skin. In a body of cells juice follows
    /// the fibres or the shortest way to the skin. A press of the pressure `pressed` [Pa] squeezes free juice out, and fresh
    /// cuts bleed.
    pub fn release_juice(&self, state: &mut FoodState, pressed: f64, dt: f64) -> Runoff {
        let reach = 1e-6 * self.kinetics.water_holding.juice_speed_um_s * dt;
        let mut runoff = Runoff::default();
        match &self.shape.mesh {
            BodyMesh::Swept(mesh) => {
                let divide = self.divide(mesh, state);
                let n = mesh.nodes_per_level();
                for level in 0..mesh.levels.len() {
                    self.free(state, dt, level * n..(level + 1) * n, divide.rising(level));
                }
                self.drain(mesh, state, reach, &mut runoff);
            }
            BodyMesh::Cells(_) => {
                self.free(state, dt, 0..state.juice.len(), 0.0);
                self.drain_cells(state, reach, &mut runoff);
            }
        }
        for &(node, area) in &self.water.outlets {
            self.run_off(state, node as usize, area, &mut runoff);
        }
        self.squeeze(state, pressed, dt, &mut runoff);
        self.bleed(state, dt, &mut runoff);
        state.dripped += runoff.mass;
        runoff
    }

    /// Film of juice on the face of each node beyond that of raw food, relative to the largest film [-]; 0 at nodes without an outlet.
    pub fn juice_films(&self, state: &FoodState) -> Vec<f64> {
        let most = self.kinetics.water_holding.film_kg_m2;
        let mut films = vec![0.0; state.juice.len()];
        for &(node, area) in &self.water.outlets {
            let (node, raw) = (node as usize, self.raw_film_left(state.peak[node as usize]));
            let beyond = state.juice[node] - raw * most * area;
            films[node] = (beyond / ((1.0 - raw) * most * area)).clamp(0.0, 1.0);
        }
        films
    }

    /// Shares of the raw water that the changes squeeze out of a block of nodes [-].
    fn squeezed(&self, state: &FoodState, block: Range<usize>) -> [f64; BLOCK] {
        let mut squeezed = [0.0; BLOCK];
        for (x, s) in self.water.squeeze.of(&state.changed) {
            squeezed.iter_mut().zip(&x[block.clone()]).for_each(|(sum, x)| *sum += s * x);
        }
        squeezed
    }

    /// Turns a share of the water beyond the capacity of each of some nodes into free juice; dried flesh takes up juice.
    /// `rising` is the share of the new juice that moves towards the upper end of the fibres [-].
    fn free(&self, state: &mut FoodState, dt: f64, nodes: Range<usize>, rising: f64) {
        for first in nodes.clone().step_by(BLOCK) {
            let block = first..nodes.end.min(first + BLOCK);
            let surplus = self.surplus(state, block.clone());
            let fields = (&mut state.juice[block.clone()], &mut state.rising[block.clone()]);
            let juices = fields.0.iter_mut().zip(fields.1);
            for (((juice, up), temperature), surplus) in juices.zip(&state.temperature[block]).zip(surplus) {
                if surplus <= 0.0 && *juice >= 0.0 {
                    (*juice, *up) = (0.0, 0.0);
                    continue;
                }
                let bound = positive(surplus - *juice);
                let released = 1.0 - 1.0 / (1.0 + self.water.release.at(*temperature) * dt);
                let free = *juice + released * bound;
                if free < surplus {
                    *up += rising * (free - *juice);
                    *juice = free;
                } else {
                    *up *= if *juice > 0.0 { surplus / *juice } else { 0.0 };
                    *juice = surplus;
                }
            }
        }
    }

    /// Water beyond the capacity of each node of a block [kg].
    ///
    /// The capacity is the smaller of the limits by the peak temperature and by the changes.
    fn surplus(&self, state: &FoodState, block: Range<usize>) -> [f64; BLOCK] {
        let mut surplus = self.squeezed(state, block.clone());
        let raw = state.peak[block.clone()].iter().zip(&self.tissue.initial_water[block.clone()]);
        for ((surplus, (peak, raw)), water) in surplus.iter_mut().zip(raw).zip(&state.water[block]) {
            let (held, unsqueezed) = (self.water.held.at(*peak), 1.0 - *surplus);
            *surplus = positive(water - raw * if held < unsqueezed { held } else { unsqueezed });
        }
        surplus
    }

    /// Removes the juice beyond the largest film on a face.
    fn run_off(&self, state: &mut FoodState, face: usize, area: f64, runoff: &mut Runoff) {
        let film = self.kinetics.water_holding.film_kg_m2 * area;
        self.let_out(state, face, film, runoff);
    }

    /// Lets the free juice of a node out but for what is `left` [kg], at its own temperature.
    pub(crate) fn let_out(&self, state: &mut FoodState, node: usize, left: f64, runoff: &mut Runoff) {
        let excess = (state.juice[node] - left).max(0.0);
        if excess > 0.0 {
            let enthalpy = excess * self.properties.water_enthalpy(state.temperature[node]);
            state.rising[node] *= left / state.juice[node];
            state.juice[node] -= excess;
            state.water[node] -= excess;
            state.enthalpy[node] -= enthalpy;
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

/// Returns a mass, or 0 where it is negative [kg].
#[inline]
fn positive(mass: f64) -> f64 {
    if mass > 0.0 { mass } else { 0.0 }
}

//! Conduction on a graph of lumped nodes and edges.

use crate::tensor::LayeredGraph;

/// Geometry of a body for conduction: what linear shape functions leave of it.
#[derive(Clone, Debug, Default)]
pub struct Graph {
    /// Lumped volume of each node [m³].
    pub volume: Vec<f64>,
    /// Both ends of each edge.
    pub ends: Vec<[u32; 2]>,
    /// Shape of each edge: area over length, ≥ 0 [m].
    pub shape: Vec<f64>,
}

impl Graph {
    /// Adds an edge of the given shape [m].
    pub fn push(&mut self, a: u32, b: u32, shape: f64) {
        self.ends.push([a, b]);
        self.shape.push(shape);
    }
}

/// Conductances of every edge of a [`Graph`], refreshed when the conductivity changes [W/K].
#[derive(Clone, Debug, Default)]
pub struct Conduction {
    conductance: Vec<f64>,
    /// Sum of the conductances at each node [W/K].
    pub total: Vec<f64>,
}

impl Conduction {
    /// Sets G = shape · k with k the harmonic mean of the ends' thermal conductivity [W/(m·K)].
    ///
    /// The harmonic mean carries the right flux where a dry crust meets wet flesh (two layers in series).
    pub fn refresh(&mut self, graph: &Graph, conductivity: &[f64]) {
        self.refresh_each(graph, |_, a, b| (conductivity[a], conductivity[b]));
    }

    /// As [`Self::refresh`], with the conductivity of both ends asked for by edge: `at(edge, a, b)` [W/(m·K)].
    pub fn refresh_each(&mut self, graph: &Graph, at: impl Fn(usize, usize, usize) -> (f64, f64)) {
        self.conductance.resize(graph.ends.len(), 0.0);
        self.total.clear();
        self.total.resize(graph.volume.len(), 0.0);
        let edges = graph.ends.iter().zip(&graph.shape).zip(&mut self.conductance);
        for (edge, ((&[a, b], &shape), g)) in edges.enumerate() {
            let (ka, kb) = at(edge, a as usize, b as usize);
            *g = shape * 2.0 * ka * kb / (ka + kb);
            self.total[a as usize] += *g;
            self.total[b as usize] += *g;
        }
    }

    /// As [`Self::refresh`] where an edge lies in a layer of its own and k is told by layer and node; a contact's shape
    /// is its conductance.
    pub fn refresh_layers(&mut self, edges: &LayeredGraph, conductivity: impl Fn(usize, usize) -> f64) {
        let graph = &edges.graph;
        self.conductance.resize(graph.ends.len(), 0.0);
        self.total.clear();
        self.total.resize(graph.volume.len(), 0.0);
        for (e, (&[a, b], &shape)) in graph.ends.iter().zip(&graph.shape).enumerate() {
            let (a, b) = (a as usize, b as usize);
            let g = edges.layer[e].map_or(shape, |layer| {
                let (ka, kb) = (conductivity(layer, a), conductivity(layer, b));
                shape * 2.0 * ka * kb / (ka + kb)
            });
            self.conductance[e] = g;
            self.total[a] += g;
            self.total[b] += g;
        }
    }

    /// Adds to `power` the net heat that conduction brings to every node [W]; the sum over all nodes is zero.
    pub fn add_power(&self, graph: &Graph, temperature: &[f64], power: &mut [f64]) {
        for (&[a, b], &g) in graph.ends.iter().zip(&self.conductance) {
            let flow = g * (temperature[b as usize] - temperature[a as usize]);
            power[a as usize] += flow;
            power[b as usize] -= flow;
        }
    }

    /// The longest explicit step that keeps every node between its neighbours' temperatures [s]: min C / ΣG over the
    /// nodes' heat capacities C [J/K].
    pub fn stable_step(&self, capacity: &[f64]) -> f64 {
        stable_step(capacity, &self.total)
    }

    /// As [`Self::stable_step`] where nodes also exchange heat explicitly with their surroundings through `exchange` [W/K].
    pub fn stable_step_with(&self, capacity: &[f64], exchange: &[f64]) -> f64 {
        let limits = capacity.iter().zip(&self.total).zip(exchange).map(|((c, g), e)| c / (g + e));
        limits.fold(f64::INFINITY, f64::min)
    }
}

/// As [`Conduction::stable_step`], for the nodes' sums of conductances [W/K].
pub(crate) fn stable_step(capacity: &[f64], total: &[f64]) -> f64 {
    capacity.iter().zip(total).map(|(c, g)| c / g).fold(f64::INFINITY, f64::min)
}

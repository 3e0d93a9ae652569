//! Explicit heat conduction over the edges of a graph of lumped nodes.

use crate::conduction::graph::Graph;
use crate::conduction::tensor::LayeredGraph;

/// Thermal conductances of all edges of a [`Graph`] [W/K].
///
/// Heat flows as Φ_ab = G_ab (T_b − T_a) with G = shape × k. G is refreshed when the thermal conductivity changes.
///
/// A stable explicit step of a piece of meat:
///
/// ```
/// use saute_heat::{Conduction, Outline, Section, SweptMesh, graded_levels};
///
/// let section = Section::mesh(&Outline::rectangle(0.04, 0.03), 2e-3, 1e-3)?;
/// let mesh = SweptMesh::new(section, graded_levels(0.02, 1e-3, 1.3, 2e-3));
/// let capacity: Vec<f64> = mesh.graph.volume.iter().map(|v| 3.7e6 * v).collect();
/// let mut conduction = Conduction::default();
/// conduction.refresh(&mesh.graph, &vec![0.48; capacity.len()]);
/// let step_s = conduction.stable_step(&capacity);
/// assert!((step_s - 1.064).abs() < 1e-3, "{step_s} s");
///
/// // One explicit step from a hot level: no node leaves the range, and energy is conserved.
/// let mut temperature: Vec<f64> = (0..mesh.node_count()).map(|n| if n < 50 { 100.0 } else { 10.0 }).collect();
/// let mut power = vec![0.0; capacity.len()];
/// conduction.add_power(&mesh.graph, &temperature, &mut power);
/// temperature.iter_mut().zip(power.iter().zip(&capacity)).for_each(|(t, (p, c))| *t += p * step_s / c);
/// assert!(temperature.iter().all(|t| (10.0 - 1e-9..=100.0 + 1e-9).contains(t)));
/// assert!(power.iter().sum::<f64>().abs() < 1e-9, "W");
/// # Ok::<(), saute_heat::MeshError>(())
/// ```
#[derive(Clone, Debug, Default)]
pub struct Conduction {
    conductance: Vec<f64>,
    /// Sum of the conductances at each node [W/K].
    pub total: Vec<f64>,
}

impl Conduction {
    /// Sets the conductances from the thermal conductivity at each node [W/(m·K)].
    ///
    /// G = shape × 2 k_a k_b / (k_a + k_b). The harmonic mean gives the exact flux through two layers in series, such
    /// as dry crust on wet flesh. Source: Patankar, Numerical Heat Transfer and Fluid Flow (1980), section 4.2-3.
    pub fn refresh(&mut self, graph: &Graph, conductivity: &[f64]) {
        self.refresh_each(graph, |_, a, b| (conductivity[a], conductivity[b]));
    }

    /// Sets the conductances from the thermal conductivity at both ends of each edge, `at(edge, a, b)` [W/(m·K)].
    ///
    /// Same rule as [`Self::refresh`], for conductivities that depend on the direction of the edge.
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

    /// Sets the conductances of a layered body from the thermal conductivity by layer and node [W/(m·K)].
    ///
    /// Same rule as [`Self::refresh`]. Each edge is in one layer; the shape of a contact is its conductance.
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

    /// Adds the net conducted heat flow into each node to `power` [W].
    ///
    /// Φ_a = Σ_b G_ab (T_b − T_a). Every flow is added at one end and subtracted at the other, so the sum over all nodes
    /// is zero to rounding: conduction conserves energy.
    pub fn add_power(&self, graph: &Graph, temperature: &[f64], power: &mut [f64]) {
        for (&[a, b], &g) in graph.ends.iter().zip(&self.conductance) {
            let flow = g * (temperature[b as usize] - temperature[a as usize]);
            power[a as usize] += flow;
            power[b as usize] -= flow;
        }
    }

    /// Returns the longest explicit Euler step that satisfies the discrete maximum principle [s].
    ///
    /// Δt = min C / ΣG over all nodes with heat capacity C [J/K]: no node then leaves the range of its neighbours'
    /// temperatures. In terms of the cell Fourier number, Σ Fo ≤ 1.
    pub fn stable_step(&self, capacity: &[f64]) -> f64 {
        stable_step(capacity, &self.total)
    }

    /// Returns the longest explicit Euler step with heat exchange to the surroundings [s].
    ///
    /// Δt = min C / (ΣG + `exchange`), with the conductance of each node's Robin boundary in `exchange` [W/K].
    pub fn stable_step_with(&self, capacity: &[f64], exchange: &[f64]) -> f64 {
        let limits = capacity.iter().zip(&self.total).zip(exchange).map(|((c, g), e)| c / (g + e));
        limits.fold(f64::INFINITY, f64::min)
    }
}

/// Longest explicit step for the nodes' sums of conductances [W/K] and heat capacities [J/K] [s].
pub(crate) fn stable_step(capacity: &[f64], total: &[f64]) -> f64 {
    capacity.iter().zip(total).map(|(c, g)| c / g).fold(f64::INFINITY, f64::min)
}

//! Conduction in a body of identical layers, computed for several layers at once.

use crate::conduction::edge_conduction::Conduction;
use crate::conduction::graph::Graph;

/// Number of layers in a block [-] (chosen: two SIMD vectors of every 64-bit processor).
const TOGETHER: usize = 4;

/// One value in each layer of a block.
type Lanes = [f64; TOGETHER];

/// Conductances of a graph whose layers have identical edges [W/K].
///
/// In the graph the edges within each layer are followed by the edges to the next layer, node by node.
#[derive(Clone, Debug)]
pub struct Layers {
    nodes: usize,
    layers: usize,
    /// Second ends of the edges within a layer, and for each node the index of its first edge.
    ends: Vec<u32>,
    starts: Vec<u32>,
    /// Conductances within layers, block by block [W/K].
    within: Vec<Lanes>,
    /// Conductances between layers [W/K].
    between: Vec<f64>,
    temperature: Vec<Lanes>,
    power: Vec<Lanes>,
}

impl Layers {
    /// Returns the layers of a graph with `nodes` nodes each, or none if the graph does not consist of such layers.
    pub fn of(graph: &Graph, nodes: usize) -> Option<Self> {
        let layers = graph.volume.len().checked_div(nodes)?;
        let edges = graph.ends.len().checked_sub(layers.checked_sub(1)? * nodes)? / layers;
        let whole = layers > 1
            && layers * nodes == graph.volume.len()
            && layers * edges + (layers - 1) * nodes == graph.ends.len();
        let first = graph.ends.get(..edges)?;
        let ascending = first.iter().all(|[a, b]| a < b && (*b as usize) < nodes) && first.is_sorted_by_key(|e| e[0]);
        let expected = |e: usize| {
            let (layer, place) = (e / (edges + nodes), e % (edges + nodes));
            let base = (layer * nodes) as u32;
            let up = |i: usize| [i as u32, (nodes + i) as u32];
            first.get(place).copied().unwrap_or_else(|| up(place - edges)).map(|node| base + node)
        };
        let layered = graph.ends.iter().enumerate().all(|(e, ends)| *ends == expected(e));
        let starts = |node: usize| first.partition_point(|e| (e[0] as usize) < node) as u32;
        (whole && ascending && layered).then(|| Self {
            nodes,
            layers,
            ends: first.iter().map(|e| e[1]).collect(),
            starts: (0..=nodes).map(starts).collect(),
            within: vec![[0.0; TOGETHER]; edges * layers.div_ceil(TOGETHER)],
            between: vec![0.0; (layers - 1) * nodes],
            temperature: vec![[0.0; TOGETHER]; nodes],
            power: vec![[0.0; TOGETHER]; nodes],
        })
    }

    /// Copies the conductances of the graph's edges.
    pub fn refresh(&mut self, conduction: &Conduction) {
        let edges = self.ends.len();
        for (layer, all) in conduction.conductance().chunks(edges + self.nodes).enumerate() {
            let (within, between) = all.split_at(edges);
            let (first, lane) = (layer / TOGETHER * edges, layer % TOGETHER);
            self.within[first..first + edges].iter_mut().zip(within).for_each(|(to, from)| to[lane] = *from);
            let first = layer * self.nodes;
            self.between[first..first + between.len()].copy_from_slice(between);
        }
    }

    /// Adds the net conducted heat flow into each node to `power` [W].
    ///
    /// Bitwise equal to [`Conduction::add_power`]: the flows into each node are added in the order of the edges.
    pub fn add_power(&mut self, temperature: &[f64], power: &mut [f64]) {
        let n = self.nodes;
        let flow = |((g, t), above): ((&f64, &f64), &f64)| g * (above - t);
        let flows = || self.between.iter().zip(temperature).zip(&temperature[n..]).map(flow);
        power[n..].iter_mut().zip(flows()).for_each(|(p, flow)| *p -= flow);
        for (block, first) in (0..self.layers).step_by(TOGETHER).enumerate() {
            self.sweep(block, first * n, temperature, power);
        }
        let flows = self.between.iter().zip(temperature).zip(&temperature[n..]).map(flow);
        power.iter_mut().zip(flows).for_each(|(p, flow)| *p += flow);
    }

    /// Adds the flows within the layers of a block whose first node is `first`.
    fn sweep(&mut self, block: usize, first: usize, temperature: &[f64], power: &mut [f64]) {
        let count = (self.layers - block * TOGETHER).min(TOGETHER);
        gather(&mut self.temperature, &temperature[first..], count);
        gather(&mut self.power, &power[first..], count);
        let edges = self.ends.len();
        let within = &self.within[block * edges..][..edges];
        for (a, edges) in self.starts.windows(2).enumerate() {
            let (t, mut p) = (self.temperature[a], self.power[a]);
            let edges = edges[0] as usize..edges[1] as usize;
            for (&b, g) in self.ends[edges.clone()].iter().zip(&within[edges]) {
                // Local copies let the compiler vectorise over the layers.
                let (other, mut to) = (self.temperature[b as usize], self.power[b as usize]);
                for k in 0..TOGETHER {
                    let flow = g[k] * (other[k] - t[k]);
                    p[k] += flow;
                    to[k] -= flow;
                }
                self.power[b as usize] = to;
            }
            self.power[a] = p;
        }
        for (lane, power) in power[first..].chunks_mut(self.nodes).take(count).enumerate() {
            power.iter_mut().zip(&self.power).for_each(|(to, from)| *to = from[lane]);
        }
    }
}

/// Interleaves the values of `count` layers.
fn gather(lanes: &mut [Lanes], field: &[f64], count: usize) {
    let n = lanes.len();
    if count == TOGETHER {
        let (below, above) = field.split_at(2 * n);
        let (first, second) = below.split_at(n);
        let (third, fourth) = above.split_at(n);
        for ((((to, a), b), c), d) in lanes.iter_mut().zip(first).zip(second).zip(third).zip(fourth) {
            *to = [*a, *b, *c, *d];
        }
        return;
    }
    for (lane, field) in field.chunks(n).take(count).enumerate() {
        lanes.iter_mut().zip(field).for_each(|(to, from)| to[lane] = *from);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Outline, Section, SweptMesh, graded_levels};

    /// For complete blocks and a remainder.
    #[test]
    fn flows_are_those_of_the_sum_over_edges_to_the_last_bit() {
        for layers in 2..10 {
            let section = Section::mesh(&Outline::rectangle(0.04, 0.03), 4e-3, 2e-3).expect("meshes");
            let levels: Vec<f64> = (0..layers).map(|l| 1e-3 * f64::from(l)).collect();
            let mesh = SweptMesh::new(section, levels);
            let value = |i: usize| 280.0 + 100.0 * libm::sin(0.7 * i as f64);
            let t: Vec<f64> = (0..mesh.node_count()).map(value).collect();
            let mut conduction = Conduction::default();
            conduction.refresh(&mesh.graph, &t);
            let mut expected = vec![0.0; t.len()];
            conduction.add_power(&mesh.graph, &t, &mut expected);
            let mut found = Layers::of(&mesh.graph, mesh.nodes_per_level()).expect("layers");
            found.refresh(&conduction);
            let mut power = vec![0.0; t.len()];
            found.add_power(&t, &mut power);
            assert!(power.iter().zip(&expected).all(|(p, e)| p.to_bits() == e.to_bits()), "{layers} layers");
        }
    }

    #[test]
    fn a_graph_of_other_order_has_no_layers() {
        let section = Section::mesh(&Outline::circle(0.01), 2e-3, 1e-3).expect("meshes");
        let mut mesh = SweptMesh::new(section, graded_levels(0.01, 1e-3, 1.3, 2e-3));
        mesh.graph.ends.swap(0, 1);
        assert!(Layers::of(&mesh.graph, mesh.nodes_per_level()).is_none());
    }
}

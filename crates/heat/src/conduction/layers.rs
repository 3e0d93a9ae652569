//! Conduction in a body of identical layers, computed for several layers at once.

use crate::conduction::edge_conduction::stable_step;
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
    /// Edges within layers, block by block.
    within: Vec<Within>,
    /// Edges between layers.
    between: Vec<Between>,
    /// Sum of the conductances at each node [W/K].
    total: Vec<f64>,
    /// Values at the nodes of a block, and sums over their edges.
    values: Vec<Lanes>,
    sums: Vec<Lanes>,
}

/// The same edge in all layers of a block.
#[derive(Clone, Copy, Debug, Default)]
struct Within {
    /// Area over length [m].
    shape: Lanes,
    /// Conductance [W/K].
    conductance: Lanes,
}

/// An edge from a layer to the next one.
#[derive(Clone, Copy, Debug, Default)]
struct Between {
    /// Area over length [m].
    shape: f64,
    /// Conductance [W/K].
    conductance: f64,
}

impl Layers {
    /// Returns the layers of a graph with `nodes` nodes each, or none if the graph does not consist of such layers.
    pub fn of(graph: &Graph, nodes: usize) -> Option<Self> {
        let layers = graph.volume.len().checked_div(nodes).filter(|layers| *layers > 1)?;
        let edges = graph.ends.len().checked_sub((layers - 1) * nodes)? / layers;
        let first = graph.ends.get(..edges)?;
        let ascending = first.iter().all(|[a, b]| a < b && (*b as usize) < nodes) && first.is_sorted_by_key(|e| e[0]);
        let whole = layers * nodes == graph.volume.len() && layers * edges + (layers - 1) * nodes == graph.ends.len();
        let expected = |e: usize| {
            let (layer, place) = (e / (edges + nodes), e % (edges + nodes));
            let base = (layer * nodes) as u32;
            let up = |i: usize| [i as u32, (nodes + i) as u32];
            first.get(place).copied().unwrap_or_else(|| up(place - edges)).map(|node| base + node)
        };
        let layered = || graph.ends.iter().enumerate().all(|(e, ends)| *ends == expected(e));
        let starts = |node: usize| first.partition_point(|e| (e[0] as usize) < node) as u32;
        (ascending && whole && layered()).then(|| {
            let mut found = Self {
                nodes,
                layers,
                ends: first.iter().map(|e| e[1]).collect(),
                starts: (0..=nodes).map(starts).collect(),
                within: vec![Within::default(); edges * layers.div_ceil(TOGETHER)],
                between: Vec::with_capacity((layers - 1) * nodes),
                total: vec![0.0; layers * nodes],
                values: vec![[0.0; TOGETHER]; nodes],
                sums: vec![[0.0; TOGETHER]; nodes],
            };
            found.take_shapes(&graph.shape);
            found
        })
    }

    fn take_shapes(&mut self, shapes: &[f64]) {
        let edges = self.ends.len();
        for (layer, all) in shapes.chunks(edges + self.nodes).enumerate() {
            let (within, between) = all.split_at(edges);
            let (first, lane) = (layer / TOGETHER * edges, layer % TOGETHER);
            let to = &mut self.within[first..first + edges];
            to.iter_mut().zip(within).for_each(|(to, from)| to.shape[lane] = *from);
            self.between.extend(between.iter().map(|&shape| Between { shape, conductance: 0.0 }));
        }
    }

    /// Sets the conductances from the nodes' thermal conductivity within layers and between them [W/(m·K)].
    ///
    /// Bitwise equal to [`Conduction::refresh_each`](crate::Conduction::refresh_each).
    pub fn refresh(&mut self, within: &[f64], between: &[f64]) {
        let n = self.nodes;
        for ((edge, ka), kb) in self.between.iter_mut().zip(between).zip(&between[n..]) {
            edge.conductance = edge.shape * 2.0 * ka * kb / (ka + kb);
        }
        self.total.fill(0.0);
        self.total[n..].iter_mut().zip(&self.between).for_each(|(sum, edge)| *sum += edge.conductance);
        for (block, first) in (0..self.layers).step_by(TOGETHER).enumerate() {
            let count = (self.layers - first).min(TOGETHER);
            gather(&mut self.values, &within[first * n..], count);
            gather(&mut self.sums, &self.total[first * n..], count);
            self.conduct(block);
            scatter(&self.sums, &mut self.total[first * n..], count);
        }
        self.total.iter_mut().zip(&self.between).for_each(|(sum, edge)| *sum += edge.conductance);
    }

    /// Sets the conductances within the layers of a block.
    fn conduct(&mut self, block: usize) {
        let edges = self.ends.len();
        let within = &mut self.within[block * edges..][..edges];
        for (a, edges) in self.starts.windows(2).enumerate() {
            let (ka, mut sum) = (self.values[a], self.sums[a]);
            let edges = edges[0] as usize..edges[1] as usize;
            for (&b, edge) in self.ends[edges.clone()].iter().zip(&mut within[edges]) {
                // Local copies let the compiler vectorise over the layers.
                let (kb, mut to, shape) = (self.values[b as usize], self.sums[b as usize], edge.shape);
                let mut conductance = [0.0; TOGETHER];
                for k in 0..TOGETHER {
                    conductance[k] = shape[k] * 2.0 * ka[k] * kb[k] / (ka[k] + kb[k]);
                    sum[k] += conductance[k];
                    to[k] += conductance[k];
                }
                (edge.conductance, self.sums[b as usize]) = (conductance, to);
            }
            self.sums[a] = sum;
        }
    }

    /// Returns the longest explicit step that satisfies the discrete maximum principle [s], as
    /// [`Conduction::stable_step`](crate::Conduction::stable_step).
    pub fn stable_step(&self, capacity: &[f64]) -> f64 {
        stable_step(capacity, &self.total)
    }

    /// Adds the net conducted heat flow into each node to `power` [W].
    ///
    /// Bitwise equal to [`Conduction::add_power`](crate::Conduction::add_power): the flows into each node are added in the
    /// order of the edges.
    pub fn add_power(&mut self, temperature: &[f64], power: &mut [f64]) {
        let n = self.nodes;
        let flow = |((edge, t), above): ((&Between, &f64), &f64)| edge.conductance * (above - t);
        let flows = self.between.iter().zip(temperature).zip(&temperature[n..]).map(flow);
        power[n..].iter_mut().zip(flows).for_each(|(p, flow)| *p -= flow);
        for (block, first) in (0..self.layers).step_by(TOGETHER).enumerate() {
            let count = (self.layers - first).min(TOGETHER);
            gather(&mut self.values, &temperature[first * n..], count);
            gather(&mut self.sums, &power[first * n..], count);
            self.sweep(block);
            scatter(&self.sums, &mut power[first * n..], count);
        }
        let flows = self.between.iter().zip(temperature).zip(&temperature[n..]).map(flow);
        power.iter_mut().zip(flows).for_each(|(p, flow)| *p += flow);
    }

    /// Adds the flows within the layers of a block.
    fn sweep(&mut self, block: usize) {
        let edges = self.ends.len();
        let within = &self.within[block * edges..][..edges];
        for (a, edges) in self.starts.windows(2).enumerate() {
            let (t, mut sum) = (self.values[a], self.sums[a]);
            let edges = edges[0] as usize..edges[1] as usize;
            for (&b, edge) in self.ends[edges.clone()].iter().zip(&within[edges]) {
                // Local copies let the compiler vectorise over the layers.
                let (other, mut to, g) = (self.values[b as usize], self.sums[b as usize], edge.conductance);
                for k in 0..TOGETHER {
                    let flow = g[k] * (other[k] - t[k]);
                    sum[k] += flow;
                    to[k] -= flow;
                }
                self.sums[b as usize] = to;
            }
            self.sums[a] = sum;
        }
    }
}

/// Writes the sums of `count` layers back to the field.
fn scatter(lanes: &[Lanes], field: &mut [f64], count: usize) {
    for (lane, field) in field.chunks_mut(lanes.len()).take(count).enumerate() {
        field.iter_mut().zip(lanes).for_each(|(to, from)| *to = from[lane]);
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
    // Unused lanes hold the values of the first layer, so that no lane divides by zero.
    lanes.iter_mut().zip(field).for_each(|(to, from)| *to = [*from; TOGETHER]);
    for (lane, field) in field.chunks(n).take(count).enumerate() {
        lanes.iter_mut().zip(field).for_each(|(to, from)| to[lane] = *from);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Conduction, Outline, Section, SweptMesh, graded_levels};

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
            let along: Vec<f64> = t.iter().map(|k| 1.3 * k).collect();
            conduction.refresh_each(&mesh.graph, |_, a, b| {
                let k = if mesh.is_along(a, b) { &along } else { &t };
                (k[a], k[b])
            });
            let mut expected = vec![0.0; t.len()];
            conduction.add_power(&mesh.graph, &t, &mut expected);
            let mut found = Layers::of(&mesh.graph, mesh.nodes_per_level()).expect("layers");
            found.refresh(&t, &along);
            assert_eq!(found.total, conduction.total, "{layers} layers");
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

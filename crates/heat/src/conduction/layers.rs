//! Conduction in a body of identical layers, computed for several layers at once.

use core::array::from_fn;

use crate::conduction::edge_conduction::stable_step;
use crate::conduction::graph::Graph;

/// Number of layers in a block [-] (chosen: four SIMD vectors of every 64-bit processor; values and sums of a thousand columns
/// stay in the second-level cache).
const TOGETHER: usize = 8;

/// One value in each layer of a block.
type Lanes = [f64; TOGETHER];

/// Conductances of a graph whose layers have identical edges [W/K].
///
/// In the graph the edges within each layer are followed by the edges to the next layer, node by node.
#[derive(Clone, Debug)]
pub struct Layers {
    nodes: usize,
    layers: usize,
    /// Second ends of the edges within a layer, and for each node the number of edges that start there.
    ends: Vec<u32>,
    degrees: Vec<u32>,
    /// Edges within layers, block by block.
    within: Edges,
    /// Edges to the next layer, block by block and column by column; those above the last layer conduct nothing.
    between: Edges,
    /// Sum of the conductances at each node [W/K].
    total: Vec<f64>,
    /// The columns of a block, and what each of their nodes adds to its sum after the edges within its layer.
    columns: Vec<Column>,
    above: Vec<Lanes>,
}

/// Edges in the order of the sweep.
#[derive(Clone, Debug)]
struct Edges {
    /// Area over length [m].
    shape: Vec<Lanes>,
    /// Conductance [W/K].
    conductance: Vec<Lanes>,
}

impl Edges {
    fn new(count: usize) -> Self {
        Self { shape: vec![[0.0; TOGETHER]; count], conductance: vec![[0.0; TOGETHER]; count] }
    }
}

/// The nodes of a block above each other: their values and the sums over their edges.
#[derive(Clone, Copy, Debug, Default)]
struct Column {
    value: Lanes,
    sum: Lanes,
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
        (ascending && whole && layered()).then(|| Self::with_edges(graph, nodes, layers, first))
    }

    /// Returns the layers whose nodes are joined by the given edges.
    fn with_edges(graph: &Graph, nodes: usize, layers: usize, edges: &[[u32; 2]]) -> Self {
        let mut degrees = vec![0; nodes];
        edges.iter().for_each(|e| degrees[e[0] as usize] += 1);
        let blocks = layers.div_ceil(TOGETHER);
        let mut found = Self {
            nodes,
            layers,
            ends: edges.iter().map(|e| e[1]).collect(),
            degrees,
            within: Edges::new(edges.len() * blocks),
            between: Edges::new(nodes * blocks),
            total: vec![0.0; layers * nodes],
            columns: vec![Column::default(); nodes],
            above: vec![[0.0; TOGETHER]; nodes],
        };
        found.take_shapes(&graph.shape);
        found
    }

    fn take_shapes(&mut self, shapes: &[f64]) {
        let edges = self.ends.len();
        for (layer, all) in shapes.chunks(edges + self.nodes).enumerate() {
            let (block, lane) = (layer / TOGETHER, layer % TOGETHER);
            let (within, between) = all.split_at(edges);
            for (to, from) in [(&mut self.within, within), (&mut self.between, between)] {
                let to = &mut to.shape[block * from.len()..][..from.len()];
                to.iter_mut().zip(from).for_each(|(to, from)| to[lane] = *from);
            }
        }
    }

    /// Sets the conductances from the nodes' thermal conductivity within layers and between them [W/(m·K)].
    ///
    /// Bitwise equal to [`Conduction::refresh_each`](crate::Conduction::refresh_each).
    pub fn refresh(&mut self, within: &[f64], between: &[f64]) {
        let mut total = core::mem::take(&mut self.total);
        for block in 0..self.blocks() {
            self.join(block, between);
            let values = self.block_of(within, block);
            for (i, column) in self.columns.iter_mut().enumerate() {
                column.value = from_fn(|k| values[k][i]);
            }
            self.conduct(block);
            self.put(block, &mut total);
        }
        self.total = total;
    }

    /// Number of blocks [-].
    fn blocks(&self) -> usize {
        self.layers.div_ceil(TOGETHER)
    }

    /// Returns the layers of a block in a field, and the one above them; in place of those above the last layer, that one.
    fn block_of<'a>(&self, field: &'a [f64], block: usize) -> [&'a [f64]; TOGETHER + 1] {
        let (n, first) = (self.nodes, block * TOGETHER);
        from_fn(|k| &field[(first + k).min(self.layers - 1) * n..][..n])
    }

    /// Sets the conductances between the layers of a block, with which the sums of its nodes begin.
    fn join(&mut self, block: usize, conductivity: &[f64]) {
        let layers = self.block_of(conductivity, block);
        let edges = block * self.nodes..(block + 1) * self.nodes;
        let edges = self.between.shape[edges.clone()].iter().zip(&mut self.between.conductance[edges]);
        for (i, ((column, above), (shape, g))) in self.columns.iter_mut().zip(&mut self.above).zip(edges).enumerate() {
            let below = if block == 0 { 0.0 } else { above[TOGETHER - 1] };
            let k: Lanes = from_fn(|layer| layers[layer][i]);
            let next: Lanes = from_fn(|layer| layers[layer + 1][i]);
            let conducts = |at: usize| shape[at] * 2.0 * k[at] * next[at] / (k[at] + next[at]);
            let all: Lanes = from_fn(conducts);
            *g = from_fn(|at| if shape[at] > 0.0 { all[at] } else { 0.0 });
            column.sum = from_fn(|at| if at == 0 { below } else { g[at - 1] });
            *above = *g;
        }
    }

    /// Sets the conductances within the layers of a block.
    fn conduct(&mut self, block: usize) {
        let edges = self.ends.len();
        let within = block * edges..(block + 1) * edges;
        let (shapes, conductances) = (&self.within.shape[within.clone()], &mut self.within.conductance[within]);
        let mut edges = 0..0;
        for (a, &degree) in self.degrees.iter().enumerate() {
            edges = edges.end..edges.end + degree as usize;
            let Column { value: ka, mut sum } = self.columns[a];
            let ends = self.ends[edges.clone()].iter();
            for ((&b, shape), g) in ends.zip(&shapes[edges.clone()]).zip(&mut conductances[edges.clone()]) {
                // A local copy lets the compiler vectorise over the layers.
                let mut to = self.columns[b as usize];
                for k in 0..TOGETHER {
                    g[k] = shape[k] * 2.0 * ka[k] * to.value[k] / (ka[k] + to.value[k]);
                    sum[k] += g[k];
                    to.sum[k] += g[k];
                }
                self.columns[b as usize].sum = to.sum;
            }
            self.columns[a].sum = sum;
        }
    }

    /// Returns the longest explicit step that satisfies the discrete maximum principle [s], as
    /// [`Conduction::stable_step`](crate::Conduction::stable_step).
    pub fn stable_step(&self, capacity: &[f64]) -> f64 {
        stable_step(capacity, &self.total)
    }

    /// Sets `power` to the net conducted heat flow into each node [W].
    ///
    /// Bitwise equal to [`Conduction::add_power`](crate::Conduction::add_power): the flows into each node are added in the
    /// order of the edges.
    pub fn power(&mut self, temperature: &[f64], power: &mut [f64]) {
        for block in 0..self.blocks() {
            self.take(block, temperature);
            self.sweep(block);
            self.put(block, power);
        }
    }

    /// Takes the temperatures of a block; the sums of its nodes begin with the flows between its layers.
    fn take(&mut self, block: usize, temperature: &[f64]) {
        let n = self.nodes;
        let layers = self.block_of(temperature, block);
        let conductances = &self.between.conductance[block * n..][..n];
        let columns = self.columns[..n].iter_mut().zip(&mut self.above[..n]).zip(conductances);
        for (i, ((column, above), g)) in columns.enumerate() {
            let below = if block == 0 { 0.0 } else { above[TOGETHER - 1] };
            // Two arrays of their own: a shifted one would be read before it is written whole.
            let t: Lanes = from_fn(|layer| layers[layer][i]);
            let next: Lanes = from_fn(|layer| layers[layer + 1][i]);
            let flow: Lanes = from_fn(|at| g[at] * (next[at] - t[at]));
            column.value = t;
            column.sum = from_fn(|at| 0.0 - if at == 0 { below } else { flow[at - 1] });
            *above = flow;
        }
    }

    /// Adds the flows within the layers of a block.
    fn sweep(&mut self, block: usize) {
        let edges = self.ends.len();
        let within = &self.within.conductance[block * edges..][..edges];
        let mut edges = 0..0;
        for (a, &degree) in self.degrees.iter().enumerate() {
            edges = edges.end..edges.end + degree as usize;
            let Column { value: t, mut sum } = self.columns[a];
            for (&b, g) in self.ends[edges.clone()].iter().zip(&within[edges.clone()]) {
                // A local copy lets the compiler vectorise over the layers.
                let mut to = self.columns[b as usize];
                for k in 0..TOGETHER {
                    let flow = g[k] * (to.value[k] - t[k]);
                    sum[k] += flow;
                    to.sum[k] -= flow;
                }
                self.columns[b as usize].sum = to.sum;
            }
            self.columns[a].sum = sum;
        }
    }

    /// Writes the sums of a block to a field, each with what comes from the layer above.
    fn put(&self, block: usize, field: &mut [f64]) {
        let n = self.nodes;
        let mut rest = &mut field[block * TOGETHER * n..];
        let mut lane = 0;
        // The last block has fewer layers.
        for (count, put) in [
            (TOGETHER, Self::put_layers::<TOGETHER> as PutLayers),
            (4, Self::put_layers::<4>),
            (1, Self::put_layers::<1>),
        ] {
            while lane + count <= TOGETHER && rest.len() >= count * n {
                let (layers, left) = rest.split_at_mut(count * n);
                put(self, lane, layers);
                (lane, rest) = (lane + count, left);
            }
        }
    }

    /// Writes the sums of `COUNT` layers from a lane on, column by column.
    fn put_layers<const COUNT: usize>(&self, lane: usize, field: &mut [f64]) {
        let mut layers = field.chunks_exact_mut(self.nodes);
        let mut layers: [&mut [f64]; COUNT] = from_fn(|_| layers.next().unwrap_or_default());
        for (i, (column, above)) in self.columns.iter().zip(&self.above).enumerate() {
            let (sum, above) = (&column.sum[lane..lane + COUNT], &above[lane..lane + COUNT]);
            for ((layer, sum), above) in layers.iter_mut().zip(sum).zip(above) {
                layer[i] = sum + above;
            }
        }
    }
}

/// Writes some layers of a field from a lane on.
type PutLayers = fn(&Layers, usize, &mut [f64]);

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Conduction, Outline, Section, SweptMesh, graded_levels};

    /// For complete blocks and a remainder.
    #[test]
    fn flows_are_those_of_the_sum_over_edges_to_the_last_bit() {
        for layers in 2..19 {
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
            let mut power = vec![f64::NAN; t.len()];
            found.power(&t, &mut power);
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

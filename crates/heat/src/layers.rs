//! Conduction in a body of like layers: the edges within them are swept for several layers at once.

use crate::conduction::{Conduction, Graph};

/// Layers that are swept together (chosen: two vectors of the plainest 64-bit processor).
const TOGETHER: usize = 4;

/// One value in each of the layers that are swept together.
type Lanes = [f64; TOGETHER];

/// The conductances of a graph whose layers have the same edges, with room for a sweep. Each layer's edges are followed by
/// those to the next layer, node by node.
#[derive(Clone, Debug)]
pub struct Layers {
    nodes: usize,
    layers: usize,
    /// The farther ends of the edges within a layer, and for each node where its edges begin among them.
    ends: Vec<u32>,
    starts: Vec<u32>,
    /// Conductances within layers, those of the layers that are swept together side by side [W/K].
    within: Vec<Lanes>,
    /// Conductances between layers [W/K].
    between: Vec<f64>,
    temperature: Vec<Lanes>,
    power: Vec<Lanes>,
}

impl Layers {
    /// The layers of so many nodes each of a graph; none where it is not made of such layers.
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

    /// Takes over the conductances of the graph's edges.
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

    /// As [`Conduction::add_power`], to the last bit: at every node the flows are added in the order of the edges.
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

    /// Adds what flows within the layers of a block, whose first node is `first`.
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
                // Taken out and put back, so that the lanes are computed side by side.
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

/// Puts the values of `count` layers side by side.
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

    /// For every number of layers, whole blocks and a rest.
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

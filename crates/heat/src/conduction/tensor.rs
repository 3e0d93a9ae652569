//! Bodies whose mesh is a product of one-dimensional meshes: slab, box, cylinder, sphere, and stacks of them.

use crate::conduction::axis::{Axis, End};
use crate::conduction::column::{Between, Column};
use crate::conduction::graph::Graph;
use crate::conduction::rule::{Rule, segment_shape};

/// A product of up to three axes; node index = Σ iₐ · stride, the first axis fastest.
#[derive(Clone, Debug)]
pub struct TensorBody {
    /// Axes.
    pub axes: Vec<Axis>,
    /// Which axis the column lies along; none where one material fills the body and nothing is up or down (a sphere).
    pub vertical: Option<usize>,
    /// Make-up of the vertical axis.
    pub column: Column,
    /// Volume of each node's cell [m³]; of a slab per m².
    pub volume: Vec<f64>,
    strides: Vec<usize>,
    cells: Vec<Vec<f64>>,
    halves: Vec<[f64; 2]>,
}

/// A piece of a node's cell that is of one material.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Part {
    /// Which layer.
    pub layer: usize,
    /// Its volume [m³]; of a slab per m².
    pub volume: f64,
}

/// Edges of a [`TensorBody`]: two-point fluxes, which are the linear elements of right-angled meshes.
#[derive(Clone, Debug, Default)]
pub struct LayeredGraph {
    /// Nodes and edges; the shape of a contact is its conductance [W/K].
    pub graph: Graph,
    /// Layer of each edge; none for a contact.
    pub layer: Vec<Option<usize>>,
}

impl LayeredGraph {
    fn push(&mut self, ends: [usize; 2], shape: f64, layer: Option<usize>) {
        if shape > 0.0 {
            self.graph.push(ends[0] as u32, ends[1] as u32, shape);
            self.layer.push(layer);
        }
    }
}

impl TensorBody {
    /// A body of one material; its last axis is vertical unless it is a radius.
    pub fn new(axes: Vec<Axis>) -> Self {
        let last = axes.len() - 1;
        let vertical = (axes[last].metric == crate::conduction::axis::Metric::Straight).then_some(last);
        let column = Column::uniform(vertical.map_or(1, |v| axes[v].nodes.len()));
        Self::stacked(axes, vertical, column)
    }

    /// A body of layers along its vertical axis.
    pub fn stacked(axes: Vec<Axis>, vertical: Option<usize>, column: Column) -> Self {
        let cells: Vec<Vec<f64>> = axes.iter().map(Axis::cells).collect();
        let halves = vertical.map_or_else(|| vec![[0.0, 1.0]], |v| axes[v].halves());
        let mut strides = Vec::new();
        let count = axes.iter().fold(1, |stride, axis| {
            strides.push(stride);
            stride * axis.nodes.len()
        });
        let mut body = Self { axes, vertical, column, volume: Vec::new(), strides, cells, halves };
        body.volume =
            (0..count).map(|n| (0..body.axes.len()).map(|a| body.cells[a][body.place(n, a)]).product()).collect();
        body
    }

    /// Nodes.
    pub fn node_count(&self) -> usize {
        self.volume.len()
    }

    /// Position of a node along an axis, as an index.
    pub fn place(&self, node: usize, axis: usize) -> usize {
        node / self.strides[axis] % self.axes[axis].nodes.len()
    }

    /// Position of a node along the vertical axis, as an index.
    pub fn storey(&self, node: usize) -> usize {
        self.vertical.map_or(0, |v| self.place(node, v))
    }

    /// Layers within a storey's height with their share of it: measure along the vertical axis [m]; 1 where there is none.
    pub fn storey_parts(&self, storey: usize) -> impl Iterator<Item = (usize, f64)> + use<> {
        let layers = if self.vertical.is_some() { self.column.layers_at(storey) } else { [None, Some(0)] };
        let [low, high] = self.halves[storey];
        let heights = if layers[0] == layers[1] { [low + high, 0.0] } else { [low, high] };
        let parts = layers.into_iter().zip(heights);
        parts.filter_map(|(layer, height)| layer.map(|l| (l, height))).filter(|(_, height)| *height > 0.0)
    }

    /// The materials of a node's cell.
    pub fn parts(&self, node: usize) -> impl Iterator<Item = Part> + use<> {
        let across = self.vertical.map_or_else(|| self.volume[node], |v| self.across(node, v));
        self.storey_parts(self.storey(node)).map(move |(layer, height)| Part { layer, volume: across * height })
    }

    /// Heat capacity of the lumped plate at a node [J/K]; of a slab per m².
    pub fn plate_capacity(&self, node: usize) -> f64 {
        match self.vertical {
            Some(v) if self.place(node, v) == 0 => self.column.plate * self.across(node, v),
            _ => 0.0,
        }
    }

    /// Measure of a node's cell across an axis.
    pub fn across(&self, node: usize, axis: usize) -> f64 {
        (0..self.axes.len()).filter(|&b| b != axis).map(|b| self.cells[b][self.place(node, b)]).product()
    }

    /// Edges under a rule.
    pub fn layered_graph(&self, rule: Rule) -> LayeredGraph {
        let mut edges = LayeredGraph::default();
        edges.graph.volume.clone_from(&self.volume);
        for node in 0..self.node_count() {
            for axis in 0..self.axes.len() {
                if self.place(node, axis) + 1 < self.axes[axis].nodes.len() {
                    self.push_link(&mut edges, node, axis, rule);
                }
            }
        }
        edges
    }

    /// Joins a node with the next along an axis.
    fn push_link(&self, edges: &mut LayeredGraph, node: usize, axis: usize, rule: Rule) {
        let (i, ends) = (self.place(node, axis), [node, node + self.strides[axis]]);
        if self.vertical == Some(axis) {
            return match self.column.between[i] {
                Between::Contact(h) => edges.push(ends, h * self.across(node, axis), None),
                Between::Layer(layer) => edges.push(ends, self.shape(ends, axis, rule), Some(layer)),
            };
        }
        let shape = self.shape(ends, axis, rule);
        for part in self.parts(node) {
            edges.push(ends, shape * part.volume / self.volume[node], Some(part.layer));
        }
    }

    fn shape(&self, ends: [usize; 2], axis: usize, rule: Rule) -> f64 {
        let i = self.place(ends[0], axis);
        match rule {
            Rule::ShapeFunctions => self.axes[axis].link(i) * self.across(ends[0], axis),
            Rule::Segments => {
                let (nodes, section) = (&self.axes[axis].nodes, self.column_section());
                let volumes = ends.map(|n| self.volume[n] * section);
                segment_shape(volumes, nodes[i + 1] - nodes[i]) / section
            }
        }
    }

    /// Section of the column that stands for an infinite slab under [`Rule::Segments`]: as wide as the mean spacing, so
    /// that evenly spaced nodes own cubes [m²]; 1 for bodies with a volume of their own.
    fn column_section(&self) -> f64 {
        if self.axes.len() > 1 || self.vertical.is_none() {
            return 1.0;
        }
        let nodes = &self.axes[0].nodes;
        let mean = (nodes[nodes.len() - 1] - nodes[0]) / (nodes.len() - 1) as f64;
        mean * mean
    }

    /// Nodes of a face with their areas [m²] (a slab: per m²; the low end of a radius has none).
    pub fn face(&self, axis: usize, end: End) -> Vec<(usize, f64)> {
        let (index, surface) = (self.axes[axis].end_node(end), self.axes[axis].end_surface(end));
        let on_face = (0..self.node_count()).filter(|&n| self.place(n, axis) == index);
        on_face.map(|n| (n, surface * self.across(n, axis))).filter(|(_, area)| *area > 0.0).collect()
    }

    /// Nodes and weights that interpolate at a point (one coordinate an axis) [m] by polynomials through `points` nodes
    /// along every axis, never across the border of a layer.
    pub fn locate(&self, point: &[f64], points: usize) -> Vec<(usize, f64)> {
        self.product((0..point.len()).map(|a| self.axes[a].weights(point[a], self.range(a, point[a]), points)))
    }

    /// Nodes and weights [1/m] that give the slope along the vertical axis at a point, taken within the layer above it.
    pub fn locate_slope(&self, point: &[f64], points: usize) -> Vec<(usize, f64)> {
        self.product((0..point.len()).map(|a| {
            let (axis, range) = (&self.axes[a], self.range(a, point[a]));
            let slope = self.vertical == Some(a);
            if slope { axis.slope_weights(point[a], range, points) } else { axis.weights(point[a], range, points) }
        }))
    }

    /// Layer at a height of the vertical axis, the upper one at a border.
    pub fn layer_at(&self, height: f64) -> Option<usize> {
        let Some(v) = self.vertical else { return Some(0) };
        let [below, above] = self.column.layers_at(self.node_below(v, height));
        above.or(below)
    }

    fn node_below(&self, axis: usize, x: f64) -> usize {
        // A point on a node belongs to what lies above it, whatever rounding did to its coordinate.
        let slack = 1e-9;
        self.axes[axis].nodes.partition_point(|&n| n <= x + slack).max(1) - 1
    }

    /// Nodes that may interpolate at `x` along an axis.
    fn range(&self, axis: usize, x: f64) -> core::ops::RangeInclusive<usize> {
        if self.vertical == Some(axis) {
            self.column.layer_around(self.node_below(axis, x))
        } else {
            0..=self.axes[axis].nodes.len() - 1
        }
    }

    fn product(&self, weights: impl Iterator<Item = Vec<(usize, f64)>>) -> Vec<(usize, f64)> {
        weights.zip(&self.strides).fold(vec![(0, 1.0)], |found, (along, stride)| {
            let pairs = found.iter().flat_map(|&(node, w)| along.iter().map(move |&(i, v)| (node + i * stride, w * v)));
            pairs.collect()
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::conduction::axis::Metric;

    fn even(length: f64, cells: usize) -> Vec<f64> {
        (0..=cells).map(|i| length * i as f64 / cells as f64).collect()
    }

    #[test]
    fn volumes_and_areas_are_those_of_the_solids() {
        use core::f64::consts::PI;
        let radius = |metric| Axis { metric, nodes: even(0.02, 10) };
        let ball = TensorBody::new(vec![radius(Metric::Spherical)]);
        assert!((ball.volume.iter().sum::<f64>() / (4.0 / 3.0 * PI * 8e-6) - 1.0).abs() < 1e-12);
        let can = TensorBody::new(vec![radius(Metric::Cylindrical), Axis::straight(even(0.05, 8))]);
        assert!((can.volume.iter().sum::<f64>() / (PI * 4e-4 * 0.05) - 1.0).abs() < 1e-12);
        let side: f64 = can.face(0, End::High).iter().map(|f| f.1).sum();
        let lid: f64 = can.face(1, End::High).iter().map(|f| f.1).sum();
        assert!((side / (2.0 * PI * 0.02 * 0.05) - 1.0).abs() < 1e-12 && (lid / (PI * 4e-4) - 1.0).abs() < 1e-12);
        assert!(can.face(0, End::Low).is_empty());
    }

    #[test]
    fn cubic_fields_are_interpolated_exactly() {
        let body = TensorBody::new(vec![
            Axis::straight(even(0.04, 5)),
            Axis::straight(even(0.03, 4)),
            Axis::straight(even(0.02, 3)),
        ]);
        let cubic = |x: f64| 1.0 + 1e3 * x * x * (1.0 - 20.0 * x);
        let field: Vec<f64> = (0..body.node_count())
            .map(|n| (0..3).map(|a| cubic(body.axes[a].nodes[body.place(n, a)])).product())
            .collect();
        let p = [0.013, 0.0291, 0.02];
        let value: f64 = body.locate(&p, 4).iter().map(|(n, w)| w * field[*n]).sum();
        assert!((value - p.iter().map(|x| cubic(*x)).product::<f64>()).abs() < 1e-12);
    }

    #[test]
    fn segments_conduct_by_the_two_thirds_power_of_the_mean_volume_over_the_length() {
        let body = TensorBody::new(vec![
            Axis::straight(vec![0.0, 1e-3, 3e-3]),
            Axis::straight(vec![0.0, 2e-3]),
            Axis::straight(vec![0.0, 4e-3, 5e-3]),
        ]);
        let edges = body.layered_graph(Rule::Segments).graph;
        assert_eq!(edges.ends.len(), body.layered_graph(Rule::ShapeFunctions).graph.ends.len());
        for (&[a, b], shape) in edges.ends.iter().zip(&edges.shape) {
            let at = |n: u32, axis: usize| body.axes[axis].nodes[body.place(n as usize, axis)];
            let length = (0..3).map(|x| (at(a, x) - at(b, x)).abs()).sum::<f64>();
            let mean = 0.5 * (body.volume[a as usize] + body.volume[b as usize]);
            assert!((shape / (mean.powf(2.0 / 3.0) / length) - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn inside_a_lattice_of_cubes_both_rules_agree() {
        let body = TensorBody::new(vec![Axis::straight(even(4e-3, 4)); 3]);
        let (a, b) = (body.layered_graph(Rule::Segments), body.layered_graph(Rule::ShapeFunctions));
        let inside = |n: u32| (0..3).all(|x| (1..=3).contains(&body.place(n as usize, x)));
        for (ends, (s, l)) in a.graph.ends.iter().zip(a.graph.shape.iter().zip(&b.graph.shape)) {
            assert!(!ends.iter().all(|n| inside(*n)) || (s / l - 1.0).abs() < 1e-12);
        }
        let slab = TensorBody::new(vec![Axis::straight(even(0.02, 40))]);
        let (a, b) = (slab.layered_graph(Rule::Segments), slab.layered_graph(Rule::ShapeFunctions));
        assert!((a.graph.shape[20] / b.graph.shape[20] - 1.0).abs() < 1e-12);
    }
}

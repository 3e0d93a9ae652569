//! Bodies on a product of one-dimensional meshes: slab, box, cylinder, sphere, and layered stacks of them.

use crate::conduction::axis::{Axis, End};
use crate::conduction::column::{Between, Column};
use crate::conduction::graph::Graph;
use crate::conduction::rule::{Rule, segment_shape};

/// A body on the product of up to three axes, with the volumes of its control volumes [m³].
///
/// Node index = Σ iₐ · strideₐ, the first axis fastest. A body with one straight axis is an infinite slab: its volumes,
/// areas and capacities are per square metre of face.
#[derive(Clone, Debug)]
pub struct TensorBody {
    /// The axes.
    pub axes: Vec<Axis>,
    /// Index of the vertical axis, along which layers are stacked; `None` for a sphere of one material.
    pub vertical: Option<usize>,
    /// Composition of the vertical axis.
    pub column: Column,
    /// Volume of each node's control volume [m³]; for a slab per square metre.
    pub volume: Vec<f64>,
    strides: Vec<usize>,
    cells: Vec<Vec<f64>>,
    halves: Vec<[f64; 2]>,
}

/// The part of a control volume that consists of one material [m³].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Part {
    /// Index of the layer.
    pub layer: usize,
    /// Volume [m³]; for a slab per square metre.
    pub volume: f64,
}

/// The edges of a [`TensorBody`] with their layers [m].
///
/// Two-point fluxes; on right-angled meshes they are identical to linear shape functions with lumped mass.
#[derive(Clone, Debug, Default)]
pub struct LayeredGraph {
    /// Nodes and edges; the shape of a contact is its conductance [W/K].
    pub graph: Graph,
    /// Layer of each edge; `None` for a contact.
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
    /// Returns a body of one material; its last axis is vertical unless it is a radius.
    pub fn new(axes: Vec<Axis>) -> Self {
        let last = axes.len() - 1;
        let vertical = (axes[last].metric == crate::conduction::axis::Metric::Straight).then_some(last);
        let column = Column::uniform(vertical.map_or(1, |v| axes[v].nodes.len()));
        Self::stacked(axes, vertical, column)
    }

    /// Returns a body with layers along its vertical axis.
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

    /// Returns the number of nodes.
    pub fn node_count(&self) -> usize {
        self.volume.len()
    }

    /// Returns the index of a node along an axis.
    pub fn place(&self, node: usize, axis: usize) -> usize {
        node / self.strides[axis] % self.axes[axis].nodes.len()
    }

    /// Returns the plane of a node: its index along the vertical axis, 0 without one.
    pub fn plane(&self, node: usize) -> usize {
        self.vertical.map_or(0, |v| self.place(node, v))
    }

    /// Returns the layers within a plane's control volumes with their heights [m]; a height of 1 without a vertical axis.
    pub fn plane_parts(&self, plane: usize) -> impl Iterator<Item = (usize, f64)> + use<> {
        let layers = if self.vertical.is_some() { self.column.layers_at(plane) } else { [None, Some(0)] };
        let [low, high] = self.halves[plane];
        let heights = if layers[0] == layers[1] { [low + high, 0.0] } else { [low, high] };
        let parts = layers.into_iter().zip(heights);
        parts.filter_map(|(layer, height)| layer.map(|l| (l, height))).filter(|(_, height)| *height > 0.0)
    }

    /// Returns the materials of a node's control volume with their volumes [m³].
    pub fn parts(&self, node: usize) -> impl Iterator<Item = Part> + use<> {
        let across = self.vertical.map_or_else(|| self.volume[node], |v| self.across(node, v));
        self.plane_parts(self.plane(node)).map(move |(layer, height)| Part { layer, volume: across * height })
    }

    /// Returns the heat capacity of the lumped plate at a node [J/K]; for a slab per square metre.
    pub fn plate_capacity(&self, node: usize) -> f64 {
        match self.vertical {
            Some(v) if self.place(node, v) == 0 => self.column.plate * self.across(node, v),
            _ => 0.0,
        }
    }

    /// Returns the measure of a node's control volume across an axis: the product over all other axes [m²].
    pub fn across(&self, node: usize, axis: usize) -> f64 {
        (0..self.axes.len()).filter(|&b| b != axis).map(|b| self.cells[b][self.place(node, b)]).product()
    }

    /// Returns the edges under a discretisation rule, with shape factors [m].
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

    /// Adds the edges between a node and the next one along an axis: one per layer, or one contact.
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

    /// Returns the shape factor of the edge between two nodes along an axis [m].
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

    /// Returns the cross-section of the column that represents an infinite slab under [`Rule::Segments`] [m²].
    ///
    /// Its width is the mean spacing, so that evenly spaced nodes have cubic control volumes. 1 for bodies of finite volume.
    fn column_section(&self) -> f64 {
        if self.axes.len() > 1 || self.vertical.is_none() {
            return 1.0;
        }
        let nodes = &self.axes[0].nodes;
        let mean = (nodes[nodes.len() - 1] - nodes[0]) / (nodes.len() - 1) as f64;
        mean * mean
    }

    /// Returns the nodes of a face with their areas [m²]; for a slab per square metre.
    ///
    /// The low end of a radius has no area and returns no node.
    pub fn face(&self, axis: usize, end: End) -> Vec<(usize, f64)> {
        let (index, surface) = (self.axes[axis].end_node(end), self.axes[axis].end_surface(end));
        let on_face = (0..self.node_count()).filter(|&n| self.place(n, axis) == index);
        on_face.map(|n| (n, surface * self.across(n, axis))).filter(|(_, area)| *area > 0.0).collect()
    }

    /// Returns nodes and weights that interpolate at a point given by one coordinate per axis [-].
    ///
    /// Polynomials through `points` nodes along every axis, never across the interface of two layers.
    pub fn locate(&self, point: &[f64], points: usize) -> Vec<(usize, f64)> {
        self.product((0..point.len()).map(|a| self.axes[a].weights(point[a], self.range(a, point[a]), points)))
    }

    /// Returns nodes and weights of the slope along the vertical axis at a point [1/m].
    ///
    /// At an interface the slope is that of the layer above.
    pub fn locate_slope(&self, point: &[f64], points: usize) -> Vec<(usize, f64)> {
        self.product((0..point.len()).map(|a| {
            let (axis, range) = (&self.axes[a], self.range(a, point[a]));
            let slope = self.vertical == Some(a);
            if slope { axis.slope_weights(point[a], range, points) } else { axis.weights(point[a], range, points) }
        }))
    }

    /// Returns the layer at a height of the vertical axis [m], the upper one at an interface.
    pub fn layer_at(&self, height: f64) -> Option<usize> {
        let Some(v) = self.vertical else { return Some(0) };
        let [below, above] = self.column.layers_at(self.node_below(v, height));
        above.or(below)
    }

    fn node_below(&self, axis: usize, x: f64) -> usize {
        // A point on a node belongs to the layer above it; the slack covers rounding of its coordinate [m].
        let slack = 1e-9;
        self.axes[axis].nodes.partition_point(|&n| n <= x + slack).max(1) - 1
    }

    /// Returns the nodes that may interpolate at `x` along an axis.
    fn range(&self, axis: usize, x: f64) -> core::ops::RangeInclusive<usize> {
        if self.vertical == Some(axis) {
            self.column.layer_around(self.node_below(axis, x))
        } else {
            0..=self.axes[axis].nodes.len() - 1
        }
    }

    /// Returns the tensor product of the weights of all axes.
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

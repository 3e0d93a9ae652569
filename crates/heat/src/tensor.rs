//! Bodies whose mesh is a product of one-dimensional meshes: slab, box, cylinder, sphere.

use crate::conduction::Graph;

/// How an axis measures length and area.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Metric {
    /// A straight axis.
    Straight,
    /// The radius of a cylinder, all the way round.
    Cylindrical,
    /// The radius of a sphere, all directions.
    Spherical,
}

/// One axis: node positions, ascending [m]; a radius starts at 0.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// How it measures.
    pub metric: Metric,
    /// Nodes [m].
    pub nodes: Vec<f64>,
}

/// Which end of an axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// The first node.
    Low,
    /// The last node.
    High,
}

impl Axis {
    /// A straight axis.
    pub fn straight(nodes: Vec<f64>) -> Self {
        Self { metric: Metric::Straight, nodes }
    }

    /// Measure enclosed up to `x`: length, area of the disc, volume of the ball.
    fn enclosed(&self, x: f64) -> f64 {
        use core::f64::consts::PI;
        match self.metric {
            Metric::Straight => x,
            Metric::Cylindrical => PI * x * x,
            Metric::Spherical => 4.0 / 3.0 * PI * x * x * x,
        }
    }

    /// Measure of the surface at `x`.
    fn surface(&self, x: f64) -> f64 {
        use core::f64::consts::PI;
        match self.metric {
            Metric::Straight => 1.0,
            Metric::Cylindrical => 2.0 * PI * x,
            Metric::Spherical => 4.0 * PI * x * x,
        }
    }

    /// Measure of the cell that belongs to each node, bounded half-way to its neighbours.
    fn cells(&self) -> Vec<f64> {
        let (nodes, last) = (&self.nodes, self.nodes.len() - 1);
        let half_way = |i: usize, j: usize| 0.5 * (nodes[i] + nodes[j]);
        (0..=last)
            .map(|i| {
                let low = if i > 0 { half_way(i - 1, i) } else { nodes[0] };
                let high = if i < last { half_way(i, i + 1) } else { nodes[last] };
                self.enclosed(high) - self.enclosed(low)
            })
            .collect()
    }

    /// Area over length between node `i` and the next.
    fn link(&self, i: usize) -> f64 {
        let (a, b) = (self.nodes[i], self.nodes[i + 1]);
        self.surface(0.5 * (a + b)) / (b - a)
    }

    /// The node below `x` and the share of the next one [-]; ends are clamped.
    fn bracket(&self, x: f64) -> (usize, f64) {
        let upper = self.nodes.partition_point(|&n| n <= x).clamp(1, self.nodes.len() - 1);
        let (low, high) = (self.nodes[upper - 1], self.nodes[upper]);
        (upper - 1, ((x - low) / (high - low)).clamp(0.0, 1.0))
    }
}

/// A product of up to three axes; node index = Σ iₐ · stride, the first axis fastest.
#[derive(Clone, Debug)]
pub struct TensorBody {
    /// Axes.
    pub axes: Vec<Axis>,
    /// Lumped volumes and edge shapes (two-point fluxes: the linear elements of right-angled meshes).
    pub graph: Graph,
    strides: Vec<usize>,
    cells: Vec<Vec<f64>>,
}

impl TensorBody {
    /// Builds volumes and edges.
    pub fn new(axes: Vec<Axis>) -> Self {
        let cells: Vec<Vec<f64>> = axes.iter().map(Axis::cells).collect();
        let mut strides = Vec::new();
        let count = axes.iter().fold(1, |stride, axis| {
            strides.push(stride);
            stride * axis.nodes.len()
        });
        let mut body = Self { axes, graph: Graph::default(), strides, cells };
        for node in 0..count {
            body.graph.volume.push((0..body.axes.len()).map(|a| body.cells[a][body.place(node, a)]).product());
            for a in 0..body.axes.len() {
                let i = body.place(node, a);
                if i + 1 < body.axes[a].nodes.len() {
                    let shape = body.axes[a].link(i) * body.across(node, a);
                    body.graph.push(node as u32, (node + body.strides[a]) as u32, shape);
                }
            }
        }
        body
    }

    /// Nodes.
    pub fn node_count(&self) -> usize {
        self.graph.volume.len()
    }

    /// Position of a node along an axis, as an index.
    fn place(&self, node: usize, axis: usize) -> usize {
        node / self.strides[axis] % self.axes[axis].nodes.len()
    }

    /// Measure of a node's cell across an axis.
    fn across(&self, node: usize, axis: usize) -> f64 {
        (0..self.axes.len()).filter(|&b| b != axis).map(|b| self.cells[b][self.place(node, b)]).product()
    }

    /// Nodes of a face with their areas [m²] (a slab: per m²; the low end of a radius has none).
    pub fn face(&self, axis: usize, end: End) -> Vec<(usize, f64)> {
        let index = if end == End::Low { 0 } else { self.axes[axis].nodes.len() - 1 };
        let surface = self.axes[axis].surface(self.axes[axis].nodes[index]);
        let on_face = (0..self.node_count()).filter(|&n| self.place(n, axis) == index);
        on_face.map(|n| (n, surface * self.across(n, axis))).filter(|(_, area)| *area > 0.0).collect()
    }

    /// Nodes and weights that interpolate linearly along every axis at a point (one coordinate an axis) [m].
    pub fn locate(&self, point: &[f64]) -> Vec<(usize, f64)> {
        let mut found = vec![(0, 1.0)];
        for (axis, &x) in point.iter().enumerate() {
            let (low, share) = self.axes[axis].bracket(x);
            found = found
                .into_iter()
                .flat_map(|(node, weight)| {
                    let at = node + low * self.strides[axis];
                    [(at, weight * (1.0 - share)), (at + self.strides[axis], weight * share)]
                })
                .filter(|(_, weight)| *weight > 0.0)
                .collect();
        }
        found
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn even(length: f64, cells: usize) -> Vec<f64> {
        (0..=cells).map(|i| length * i as f64 / cells as f64).collect()
    }

    #[test]
    fn volumes_and_areas_are_those_of_the_solids() {
        use core::f64::consts::PI;
        let radius = |metric| Axis { metric, nodes: even(0.02, 10) };
        let ball = TensorBody::new(vec![radius(Metric::Spherical)]);
        assert!((ball.graph.volume.iter().sum::<f64>() / (4.0 / 3.0 * PI * 8e-6) - 1.0).abs() < 1e-12);
        let can = TensorBody::new(vec![radius(Metric::Cylindrical), Axis::straight(even(0.05, 8))]);
        assert!((can.graph.volume.iter().sum::<f64>() / (PI * 4e-4 * 0.05) - 1.0).abs() < 1e-12);
        let side: f64 = can.face(0, End::High).iter().map(|f| f.1).sum();
        let lid: f64 = can.face(1, End::High).iter().map(|f| f.1).sum();
        assert!((side / (2.0 * PI * 0.02 * 0.05) - 1.0).abs() < 1e-12 && (lid / (PI * 4e-4) - 1.0).abs() < 1e-12);
        assert!(can.face(0, End::Low).is_empty());
    }

    #[test]
    fn linear_fields_are_interpolated_exactly() {
        let body = TensorBody::new(vec![
            Axis::straight(even(0.04, 5)),
            Axis::straight(even(0.03, 4)),
            Axis::straight(even(0.02, 3)),
        ]);
        let field: Vec<f64> = (0..body.node_count())
            .map(|n| 3.0 + (0..3).map(|a| (a as f64 + 1.0) * body.axes[a].nodes[body.place(n, a)]).sum::<f64>())
            .collect();
        let p = [0.013, 0.0291, 0.02];
        let value: f64 = body.locate(&p).iter().map(|(n, w)| w * field[*n]).sum();
        assert!((value - (3.0 + 0.013 + 2.0 * 0.0291 + 3.0 * 0.02)).abs() < 1e-12);
    }
}

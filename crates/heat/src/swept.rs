//! A cross-section carried along z in layers: prisms with linear shape functions.

use crate::conduction::Graph;
use crate::rule::{Rule, segment_shape};
use crate::section::Section;

/// A swept body: node `level · n + i` lies at `section.points[i]`, height `levels[level]`.
#[derive(Clone, Debug)]
pub struct SweptMesh {
    /// The cross-section that is carried along.
    pub section: Section,
    /// Heights of the layers, ascending from 0 [m].
    pub levels: Vec<f64>,
    /// Lumped volumes and edge shapes.
    pub graph: Graph,
}

impl SweptMesh {
    /// Builds volumes and edges under the shape functions: in-plane cotangent weight × layer height, along the path node
    /// area ÷ spacing.
    pub fn new(section: Section, levels: Vec<f64>) -> Self {
        Self::with_rule(section, levels, Rule::ShapeFunctions)
    }

    /// Builds volumes and edges under a rule. Segments run along every side of every triangle, in every layer, and along
    /// the path.
    pub fn with_rule(section: Section, levels: Vec<f64>, rule: Rule) -> Self {
        let mut mesh = Self::by_shape_functions(section, levels);
        if rule == Rule::Segments {
            mesh.graph = mesh.segments();
        }
        mesh
    }

    fn segments(&self) -> Graph {
        let n = self.nodes_per_level();
        let mut graph = Graph { volume: self.graph.volume.clone(), ..Graph::default() };
        let mut push = |a: usize, b: usize, length: f64| {
            let shape = segment_shape([self.graph.volume[a], self.graph.volume[b]], length);
            graph.push(a as u32, b as u32, shape);
        };
        let sides = self.section.sides();
        for level in 0..self.levels.len() {
            for &[a, b] in &sides {
                let (p, q) = (self.section.points[a as usize], self.section.points[b as usize]);
                let length = libm::hypot(p[0] - q[0], p[1] - q[1]);
                push(level * n + a as usize, level * n + b as usize, length);
            }
            if level + 1 < self.levels.len() {
                (0..n).for_each(|i| {
                    push(level * n + i, (level + 1) * n + i, self.levels[level + 1] - self.levels[level])
                });
            }
        }
        graph
    }

    fn by_shape_functions(section: Section, levels: Vec<f64>) -> Self {
        let n = section.points.len();
        let heights = layer_heights(&levels);
        let mut volume = Vec::with_capacity(n * levels.len());
        let mut graph = Graph::default();
        for (level, height) in heights.iter().enumerate() {
            volume.extend(section.areas.iter().map(|a| a * height));
            let base = (level * n) as u32;
            for &(a, b, weight) in &section.edges {
                graph.push(base + a, base + b, weight * height);
            }
            if level + 1 < levels.len() {
                let spacing = levels[level + 1] - levels[level];
                for (i, area) in section.areas.iter().enumerate() {
                    graph.push(base + i as u32, base + (n + i) as u32, area / spacing);
                }
            }
        }
        graph.volume = volume;
        Self { section, levels, graph }
    }

    /// Whether the edge between two nodes runs along the path.
    #[inline]
    pub fn is_along(&self, a: usize, b: usize) -> bool {
        a.abs_diff(b) == self.section.points.len()
    }

    /// Nodes in one level.
    pub fn nodes_per_level(&self) -> usize {
        self.section.points.len()
    }

    /// All nodes.
    pub fn node_count(&self) -> usize {
        self.section.points.len() * self.levels.len()
    }

    /// Index of node `i` of the section at `level`.
    pub fn node(&self, level: usize, i: usize) -> usize {
        level * self.section.points.len() + i
    }

    /// Height of the body [m].
    pub fn thickness(&self) -> f64 {
        self.levels[self.levels.len() - 1]
    }

    /// Height of the slab of material that belongs to each level [m].
    pub fn layer_heights(&self) -> Vec<f64> {
        layer_heights(&self.levels)
    }

    /// Side area of every node, level-major like the nodes [m²] (0 inside).
    pub fn side_areas(&self) -> Vec<f64> {
        let lengths = self.section.boundary_lengths();
        let heights = self.layer_heights();
        heights.iter().flat_map(|h| lengths.iter().map(move |l| l * h)).collect()
    }

    /// Position of a node, origin at the bottom centre [m].
    pub fn position(&self, node: usize) -> [f64; 3] {
        let n = self.nodes_per_level();
        let [x, y] = self.section.points[node % n];
        [x, y, self.levels[node / n]]
    }

    /// The two levels that bracket a height and the weight of the upper one [-]; ends are clamped.
    pub fn bracket(&self, z: f64) -> (usize, f64) {
        let upper = self.levels.partition_point(|&l| l <= z).clamp(1, self.levels.len() - 1);
        let (low, high) = (self.levels[upper - 1], self.levels[upper]);
        (upper - 1, ((z - low) / (high - low)).clamp(0.0, 1.0))
    }
}

fn layer_heights(levels: &[f64]) -> Vec<f64> {
    (0..levels.len())
        .map(|i| {
            let below = if i > 0 { levels[i] - levels[i - 1] } else { 0.0 };
            let above = if i + 1 < levels.len() { levels[i + 1] - levels[i] } else { 0.0 };
            0.5 * (below + above)
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{graded_levels, outline::Outline};

    #[test]
    fn volumes_and_sides_add_up() {
        let outline = Outline::rectangle(0.04, 0.03);
        let section = Section::mesh(&outline, 2e-3, 1e-3).expect("meshes");
        let mesh = SweptMesh::new(section, graded_levels(0.02, 0.5e-3, 1.3, 2e-3));
        let volume: f64 = mesh.graph.volume.iter().sum();
        assert!((volume / (0.04 * 0.03 * 0.02) - 1.0).abs() < 1e-9);
        let side: f64 = mesh.side_areas().iter().sum();
        assert!((side / (0.14 * 0.02) - 1.0).abs() < 1e-9);
    }

    #[test]
    fn segments_follow_every_side_of_every_triangle() {
        let section = Section::mesh(&Outline::rectangle(0.04, 0.03), 4e-3, 2e-3).expect("meshes");
        let (sides, nodes) = (section.sides().len(), section.points.len());
        let mesh = SweptMesh::with_rule(section, graded_levels(0.02, 1e-3, 1.3, 4e-3), Rule::Segments);
        assert_eq!(mesh.graph.ends.len(), mesh.levels.len() * sides + (mesh.levels.len() - 1) * nodes);
        for (&[a, b], shape) in mesh.graph.ends.iter().zip(&mesh.graph.shape) {
            let (p, q) = (mesh.position(a as usize), mesh.position(b as usize));
            let length = (0..3).map(|x| (p[x] - q[x]) * (p[x] - q[x])).sum::<f64>().sqrt();
            let mean = 0.5 * (mesh.graph.volume[a as usize] + mesh.graph.volume[b as usize]);
            assert!((shape / (mean.powf(2.0 / 3.0) / length) - 1.0).abs() < 1e-9);
        }
    }

    #[test]
    fn bracket_clamps_at_both_ends() {
        let section = Section::mesh(&Outline::circle(0.01), 2e-3, 1e-3).expect("meshes");
        let mesh = SweptMesh::new(section, vec![0.0, 1.0, 3.0]);
        assert_eq!(mesh.bracket(-1.0), (0, 0.0));
        assert_eq!(mesh.bracket(2.0), (1, 0.5));
        assert_eq!(mesh.bracket(9.0), (1, 1.0));
    }
}

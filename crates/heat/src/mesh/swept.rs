//! A cross-section swept along a path in levels: prisms with linear shape functions and lumped mass.

use glam::DVec3;

use crate::conduction::graph::Graph;
use crate::conduction::rule::{Rule, segment_shape};
use crate::mesh::locate::Locator;
use crate::mesh::path::{Path, Station};
use crate::mesh::section::Section;

/// Least component along the path ÷ distance of two successive nodes [-] (chosen: only folded paths reach it).
const SLIVER: f64 = 1e-3;

/// A swept body with lumped volumes [m³] and edge shapes [m].
///
/// Node `level · n + i` is node `i` of the section at `level` of the path, with n nodes per level.
#[derive(Clone, Debug)]
pub struct SweptMesh {
    /// The swept cross-section.
    pub section: Section,
    /// Distances of the levels along the path, ascending from 0; heights if it is straight [m].
    pub levels: Vec<f64>,
    /// The path of the section.
    pub path: Path,
    /// Lumped volumes and edge shapes.
    pub graph: Graph,
    pub(super) locator: Locator,
}

impl SweptMesh {
    /// Returns a body swept straight up to the heights `levels` [m], with linear shape functions.
    ///
    /// Edge shapes are cotangent weight × layer height in the plane, and lumped area ÷ spacing along the path.
    pub fn new(section: Section, levels: Vec<f64>) -> Self {
        Self::with_rule(section, levels, Rule::ShapeFunctions)
    }

    /// Returns a body swept straight up to the heights `levels` [m], with a discretisation rule.
    ///
    /// Under [`Rule::Segments`] rods run along every side of every triangle, in every level, and along the path.
    pub fn with_rule(section: Section, levels: Vec<f64>, rule: Rule) -> Self {
        Self::upright(section, levels, Path::Straight, rule)
    }

    /// Returns a body swept straight up to the mean heights `levels` [m], with a relative height for each column.
    ///
    /// Column height ÷ mean height is 1 + `variation` − its mean [-]. Volumes and in-plane conductances are proportional to
    /// it; conductances along the path are inversely proportional. Valid for gentle slopes: the areas of the faces are those
    /// of the flat section.
    pub fn uneven(section: Section, levels: Vec<f64>, variation: impl Fn([f64; 2]) -> f64, rule: Rule) -> Self {
        let path = Path::uneven(&section, variation);
        Self::upright(section, levels, path, rule)
    }

    /// Returns a body swept straight up with its graph.
    fn upright(section: Section, levels: Vec<f64>, path: Path, rule: Rule) -> Self {
        let mut mesh = Self::bare(section, levels, path);
        mesh.graph = mesh.upright_graph();
        if rule == Rule::Segments {
            mesh.graph = mesh.segments();
        }
        mesh
    }

    /// Returns a body swept along stations [m].
    ///
    /// The volume of a node is that of the two half frusta between its lumped areas on this and the neighbouring levels. Edge
    /// shapes along the path are geometric mean of the areas ÷ run, exact for a cone as sections in series; in the plane they
    /// are cotangent weight of the local section × height of the control volume.
    pub fn along(section: Section, path: Vec<Station>, rule: Rule) -> Self {
        let mut levels = vec![0.0];
        for (level, pair) in path.windows(2).enumerate() {
            let [a, b] = [&pair[0], &pair[1]].map(|station| DVec3::from(station.centre));
            levels.push(levels[level] + a.distance(b));
        }
        let mut mesh = Self::bare(section, levels, Path::Stations(path));
        mesh.graph = mesh.station_graph();
        if rule == Rule::Segments {
            mesh.graph = mesh.segments();
        }
        mesh
    }

    /// Returns a straight body with a given graph, such as a product mesh whose section has no triangles.
    pub fn with_graph(section: Section, levels: Vec<f64>, graph: Graph) -> Self {
        Self { graph, ..Self::bare(section, levels, Path::Straight) }
    }

    /// Returns a body without volumes and edges.
    fn bare(section: Section, levels: Vec<f64>, path: Path) -> Self {
        let locator = Locator::new(&section);
        Self { section, levels, path, graph: Graph::default(), locator }
    }

    /// Returns true if the section is swept straight up, with even or uneven height: the body is a slice.
    #[inline]
    pub fn is_upright(&self) -> bool {
        self.stations().is_none()
    }

    /// Returns the stations of the path, one per level, or `None` if it is straight.
    #[inline]
    pub fn stations(&self) -> Option<&[Station]> {
        match &self.path {
            Path::Stations(stations) => Some(stations),
            Path::Straight | Path::Uneven(_) => None,
        }
    }

    /// Returns the smallest distance between two levels [m].
    pub fn first_layer(&self) -> f64 {
        self.levels.windows(2).map(|w| w[1] - w[0]).fold(f64::INFINITY, f64::min)
    }

    /// Returns the graph under [`Rule::Segments`] with the volumes of the present one.
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
                let (a, b) = (level * n + a as usize, level * n + b as usize);
                push(a, b, self.length(a, b));
            }
            if level + 1 < self.levels.len() {
                (0..n).for_each(|i| {
                    let (a, b) = (level * n + i, (level + 1) * n + i);
                    let upright = !matches!(self.path, Path::Stations(_));
                    push(a, b, if upright { self.run(level, i) } else { self.length(a, b) });
                });
            }
        }
        graph
    }

    /// Returns the distance between two nodes of one level; on a straight path, that in the section [m].
    fn length(&self, a: usize, b: usize) -> f64 {
        if let Path::Straight = self.path {
            let n = self.nodes_per_level();
            let (p, q) = (self.section.points[a % n], self.section.points[b % n]);
            return libm::hypot(p[0] - q[0], p[1] - q[1]);
        }
        DVec3::from(self.position(a)).distance(self.position(b).into())
    }

    /// Returns the distance along the path from node `i` of a level to the same node of the next [m].
    ///
    /// It is the component along the mean direction of both levels, less than the distance if the section tapers.
    pub fn run(&self, level: usize, i: usize) -> f64 {
        let Path::Stations(stations) = &self.path else {
            return (self.levels[level + 1] - self.levels[level]) * self.path.column(i);
        };
        let [p, q] = [level, level + 1].map(|l| DVec3::from(self.position(self.node(l, i))));
        let along = stations[level].along() + stations[level + 1].along();
        let way = q - p;
        // The lower limit keeps volumes and conductances positive where a sharply bent path folds.
        (way.dot(along) / along.length()).max(SLIVER * way.length())
    }

    /// Returns the graph of a body swept straight up.
    fn upright_graph(&self) -> Graph {
        let (n, levels, path) = (self.nodes_per_level(), &self.levels, &self.path);
        let section = &self.section;
        let mut graph = Graph::default();
        for (level, height) in layer_heights(levels).iter().enumerate() {
            graph.volume.extend(section.areas.iter().enumerate().map(|(i, a)| a * height * path.column(i)));
            let base = (level * n) as u32;
            for &(a, b, weight) in &section.edges {
                let mean = 0.5 * (path.column(a as usize) + path.column(b as usize));
                graph.push(base + a, base + b, weight * height * mean);
            }
            if level + 1 < levels.len() {
                for (i, area) in section.areas.iter().enumerate() {
                    graph.push(base + i as u32, base + (n + i) as u32, area / self.run(level, i));
                }
            }
        }
        graph
    }

    /// Returns the graph of a body swept along stations.
    fn station_graph(&self) -> Graph {
        let (n, last) = (self.nodes_per_level(), self.levels.len() - 1);
        let mut graph = Graph { volume: vec![0.0; self.node_count()], ..Graph::default() };
        let mut thick = vec![0.0; self.node_count()];
        for level in 0..last {
            for i in 0..n {
                let (a, b) = (self.node(level, i), self.node(level + 1, i));
                let (run, areas) = (self.run(level, i), [self.node_area(level, i), self.node_area(level + 1, i)]);
                graph.push(a as u32, b as u32, libm::sqrt(areas[0] * areas[1]) / run);
                let halves = frustum_halves(areas);
                for (node, mean) in [(a, halves[0]), (b, halves[1])] {
                    graph.volume[node] += 0.5 * run * mean;
                    thick[node] += 0.5 * run;
                }
            }
        }
        for level in 0..=last {
            for &(a, b, weight) in &self.section_at(level).edges {
                let (a, b) = (self.node(level, a as usize), self.node(level, b as usize));
                graph.push(a as u32, b as u32, weight * 0.5 * (thick[a] + thick[b]));
            }
        }
        graph
    }

    /// Returns true if the edge between two nodes runs along the path.
    #[inline]
    pub fn is_along(&self, a: usize, b: usize) -> bool {
        a.abs_diff(b) == self.section.points.len()
    }

    /// Returns the number of nodes per level.
    pub fn nodes_per_level(&self) -> usize {
        self.section.points.len()
    }

    /// Returns the number of nodes.
    pub fn node_count(&self) -> usize {
        self.section.points.len() * self.levels.len()
    }

    /// Returns the index of node `i` of the section at `level`.
    pub fn node(&self, level: usize, i: usize) -> usize {
        level * self.section.points.len() + i
    }

    /// Returns the length of the path; the mean height of a slice [m].
    pub fn thickness(&self) -> f64 {
        self.levels[self.levels.len() - 1]
    }

    /// Returns the height of the control volumes of each level [m].
    pub fn layer_heights(&self) -> Vec<f64> {
        layer_heights(&self.levels)
    }

    /// Returns the local section at a level [m].
    pub fn section_at(&self, level: usize) -> &Section {
        match &self.path {
            Path::Stations(stations) => &stations[level].section,
            Path::Straight | Path::Uneven(_) => &self.section,
        }
    }

    /// Returns the lumped area of node `i` of the section at `level` [m²].
    pub fn node_area(&self, level: usize, i: usize) -> f64 {
        self.section_at(level).areas[i]
    }

    /// Returns the volume between node `i` of a level and of the next [m³].
    pub fn between(&self, level: usize, i: usize) -> f64 {
        let areas = [self.node_area(level, i), self.node_area(level + 1, i)];
        match self.path {
            Path::Stations(_) => 0.5 * self.run(level, i) * frustum_halves(areas).iter().sum::<f64>(),
            Path::Straight | Path::Uneven(_) => areas[0] * self.run(level, i),
        }
    }

    /// Returns the position of a node, from the bottom centre of a slice, otherwise in the frame of the stations [m].
    pub fn position(&self, node: usize) -> [f64; 3] {
        let n = self.nodes_per_level();
        let (level, i) = (node / n, node % n);
        if let Path::Stations(stations) = &self.path {
            return stations[level].place(stations[level].section.points[i]);
        }
        let [x, y] = self.section.points[i];
        [x, y, self.levels[level] * self.path.column(i)]
    }
}

/// Returns the mean areas of both halves of a frustum between two areas [m²].
fn frustum_halves([a, b]: [f64; 2]) -> [f64; 2] {
    let root = 0.5 * (libm::sqrt(a) + libm::sqrt(b));
    [a, b].map(|end| (end + libm::sqrt(end) * root + root * root) / 3.0)
}

/// Returns the height of the control volumes of each level: half the distance to each neighbour [m].
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
    use crate::{graded_levels, mesh::outline::Outline};

    #[test]
    fn volumes_and_side_areas_sum_to_those_of_the_body() {
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
}

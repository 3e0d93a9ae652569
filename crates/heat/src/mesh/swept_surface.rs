//! The surface of a swept body: areas and triangles of its side and of its two ends.

use glam::DVec3;

use crate::mesh::outline::Outline;
use crate::mesh::path::{Path, Station};
use crate::mesh::swept::SweptMesh;

impl SweptMesh {
    /// Returns the side area of every node, 0 inside [m²].
    pub fn side_areas(&self) -> Vec<f64> {
        if let Path::Stations(_) = self.path {
            return self.shared_areas(&self.side_triangles());
        }
        let lengths = self.section.boundary_lengths();
        let heights = self.layer_heights();
        let side = |h: f64| lengths.iter().enumerate().map(move |(i, l)| (i, l * h));
        heights.iter().flat_map(|h| side(*h)).map(|(i, area)| area * self.path.column(i)).collect()
    }

    /// Returns the triangles of the side surface, counter-clockwise seen from outside.
    pub fn side_triangles(&self) -> Vec<[u32; 3]> {
        let mut triangles = Vec::new();
        for level in 0..self.levels.len().saturating_sub(1) {
            for &[a, b] in &self.section.boundary {
                let at = |level: usize, i: u32| self.node(level, i as usize) as u32;
                let [a, b, c, d] = [at(level, a), at(level, b), at(level + 1, b), at(level + 1, a)];
                triangles.extend([[a, b, c], [a, c, d]]);
            }
        }
        triangles
    }

    /// Returns the triangles of the end face at the start (`false`) or end (`true`), counter-clockwise seen from outside.
    pub fn end_triangles(&self, last: bool) -> Vec<[u32; 3]> {
        let level = if last { self.levels.len() - 1 } else { 0 };
        let of = |t: &[u32; 3]| t.map(|i| self.node(level, i as usize) as u32);
        let outward = |[a, b, c]: [u32; 3]| if last { [a, b, c] } else { [a, c, b] };
        self.section.triangles.iter().map(|t| outward(of(t))).collect()
    }

    /// Returns the lumped areas of triangles: each node gets a third of the area of its triangles [m²].
    fn shared_areas(&self, triangles: &[[u32; 3]]) -> Vec<f64> {
        let mut areas = vec![0.0; self.node_count()];
        for t in triangles {
            let [p, q, r] = t.map(|node| DVec3::from(self.position(node as usize)));
            let doubled = (q - p).cross(r - p).length();
            t.iter().for_each(|&node| areas[node as usize] += doubled / 6.0);
        }
        areas
    }

    /// Returns the depth of each node below the nearer end face, or below the side of a body on stations if that is nearer [m].
    pub fn depths(&self) -> Vec<f64> {
        let below_ends = |level: usize, i: usize| {
            let z = self.levels[level];
            z.min(self.thickness() - z) * self.path.column(i)
        };
        let columns = self.nodes_per_level();
        let mut depths: Vec<f64> =
            (0..self.levels.len() * columns).map(|node| below_ends(node / columns, node % columns)).collect();
        if let Path::Stations(stations) = &self.path {
            let rim = self.section.rim();
            for (level, Station { section, .. }) in stations.iter().enumerate() {
                let rim = Outline { points: rim.iter().map(|&i| section.points[i as usize]).collect() };
                let depths = depths[level * columns..].iter_mut().zip(&section.points);
                depths.for_each(|(depth, &point)| *depth = depth.min(rim.distance_to(point)));
            }
        }
        depths
    }
}

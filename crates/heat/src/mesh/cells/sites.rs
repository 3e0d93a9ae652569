//! The cells of nodes: the part of space nearest to each, cut off at the surface.

use std::collections::BTreeSet;

use glam::DVec3;

use crate::mesh::cells::cell::{Cell, Wall};
use crate::mesh::cells::cell_mesh::CellMesh;
use crate::mesh::cells::point_grid::PointGrid;
use crate::mesh::cells::sample::{Sample, convex};

/// Nodes and the samples of the surface above them.
pub(super) struct Sites<'a, N, S> {
    /// The positions of the nodes [m].
    pub(super) grid: &'a PointGrid,
    /// Position [m] and sample of a node.
    pub(super) site: N,
    /// A sample by its index.
    pub(super) sample: S,
}

impl<N: Fn(u32) -> (DVec3, u32), S: Fn(u32) -> Sample> Sites<'_, N, S> {
    /// Returns the Voronoi cell of a node, cut off at the planes of the surface samples near it.
    pub(super) fn cell(&self, node: u32, spacing: f64) -> Cell {
        let (position, sample) = (self.site)(node);
        let mut reach = 1.7 * spacing;
        let mut cell = loop {
            let mut cell = Cell::cube(2.0 * spacing);
            self.clip_skin(&mut cell, position, sample);
            self.grid.clip_bisectors(&mut cell, position, reach, Some(node));
            if 2.0 * cell.reach() <= reach || reach > 8.0 * spacing {
                break cell;
            }
            reach = 2.0 * cell.reach();
        };
        let neighbours: BTreeSet<u32> = cell
            .facets
            .iter()
            .filter_map(|f| if let Wall::Node(n) = f.wall { Some((self.site)(n).1) } else { None })
            .filter(|&s| s != sample && convex(&(self.sample)(sample), &(self.sample)(s)))
            .collect();
        neighbours.into_iter().for_each(|s| self.clip_skin(&mut cell, position, s));
        cell
    }

    /// Clips a cell at the plane of a sample, unless the node itself is outside of it.
    fn clip_skin(&self, cell: &mut Cell, position: DVec3, sample: u32) {
        let plane = (self.sample)(sample);
        let offset = (plane.position - position).dot(plane.normal);
        if offset >= 0.0 {
            cell.clip(plane.normal, offset, Wall::Skin(sample));
        }
    }
}

impl CellMesh {
    /// Returns the faces of a node's cell as polygons, counter-clockwise seen from outside [m].
    ///
    /// The cells fill the body up to the misfit that [`CellMesh::fit`] states.
    pub fn cell_faces(&self, node: usize) -> Vec<Vec<[f64; 3]>> {
        let site = |node: u32| (self.node(node as usize), self.samples[node as usize]);
        // A sample is a node, and the node at its own place.
        let sample = |s: u32| Sample { position: self.node(s as usize), normal: self.normals[s as usize] };
        let cell = Sites { grid: &self.grid, site, sample }.cell(node as u32, self.fineness.spacing);
        let at = self.node(node);
        let polygon = |corners: &[DVec3]| corners.iter().map(|p| (at + *p).to_array()).collect();
        cell.facets.iter().map(|facet| polygon(facet.corners())).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Fineness, Soup, Surface};

    /// A cube of 20 mm in millimetres.
    fn cube() -> CellMesh {
        let corner = |k: u32| [k & 1, k >> 1 & 1, k >> 2].map(|bit| 20.0 * f64::from(bit));
        let sides = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
        let triangles = sides.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
        let soup = Soup { vertices: (0..8).map(corner).collect(), triangles, ..Soup::default() };
        let surface = Surface::close(&soup, 1e-3).expect("closes").centred(1.0);
        let fineness = Fineness::of(&surface, 3.0);
        CellMesh::new(surface, fineness).expect("fits")
    }

    /// Volume that polygons enclose, by the divergence theorem [m³].
    fn enclosed(faces: &[Vec<[f64; 3]>]) -> f64 {
        let of_face = |face: &Vec<[f64; 3]>| {
            let at = |k: usize| DVec3::from(face[k]);
            (2..face.len()).map(|k| at(0).dot(at(k - 1).cross(at(k))) / 6.0).sum::<f64>()
        };
        faces.iter().map(of_face).sum()
    }

    /// On a symmetric body corners of several cells coincide to the last bit, and rounding may take one of them off a cell.
    #[test]
    fn the_faces_of_cells_enclose_their_volumes() {
        let mesh = cube();
        let volumes: Vec<f64> =
            (0..mesh.node_count()).map(|node| enclosed(&mesh.cell_faces(node)) / mesh.fit[0]).collect();
        let same = volumes.iter().zip(&mesh.graph.volume).filter(|(found, known)| (*found / *known - 1.0).abs() < 1e-9);
        let (same, all) = (same.count(), volumes.len());
        assert!(20 * same > 19 * all, "{same} of {all} cells");
        let whole: f64 = volumes.iter().sum();
        assert!((whole / 8e-6 - 1.0).abs() < 0.01, "{whole} m³");
    }
}

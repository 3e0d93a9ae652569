//! Interpolation between the nodes of a body of cells.

use glam::DVec3;

use crate::mesh::cells::cell::{Cell, Wall};
use crate::mesh::cells::cell_mesh::CellMesh;
/// Nodes around a point with their interpolation weights; the weights sum to 1 [-].
pub type Weights = Vec<(u32, f64)>;

impl CellMesh {
    /// Returns the node nearest to a point [m].
    pub fn nearest(&self, p: [f64; 3]) -> u32 {
        self.grid.nearest(p.into(), 0.5 * self.fineness.spacing, |_| true).unwrap_or(0)
    }

    /// Returns true if a point [m] is inside: below the surface plane over its nearest node.
    pub fn contains(&self, p: [f64; 3]) -> bool {
        let node = self.nearest(p) as usize;
        let above = (DVec3::from(p) - self.node(node)).dot(self.normals[node]);
        above <= self.depth[node] * (1.0 + 1e-9) + 1e-12
    }

    /// Returns the interpolation weights at a point [m], exact for linear fields inside [-].
    ///
    /// Laplace (non-Sibson) natural-neighbour weights: wₖ ∝ face area ÷ distance of the Voronoi cell that a node at the
    /// point would have. Source: Belikov et al. 1997, Comput. Math. Math. Phys. 37:9.
    pub fn weights(&self, p: [f64; 3]) -> Weights {
        let (nearest, p) = (self.nearest(p), DVec3::from(p));
        let gap = self.node(nearest as usize).distance(p);
        if gap < 1e-6 * self.fineness.spacing {
            return vec![(nearest, 1.0)];
        }
        let spacing = self.fineness.spacing;
        let mut reach = 1.7 * spacing;
        let cell = loop {
            let mut cell = Cell::cube(2.0 * spacing);
            let normal = self.normals[nearest as usize];
            let plane = (self.node(nearest as usize) - p).dot(normal) + self.depth[nearest as usize];
            cell.clip(normal, plane.max(0.0), Wall::Skin(0));
            self.grid.clip_bisectors(&mut cell, p, reach, None);
            if 2.0 * cell.reach() <= reach || reach > 8.0 * spacing {
                break cell;
            }
            reach = 2.0 * cell.reach();
        };
        let mut weights: Weights = Vec::with_capacity(cell.facets.len());
        for facet in &cell.facets {
            if let Wall::Node(node) = facet.wall {
                weights.push((node, facet.area() / facet.offset));
            }
        }
        let sum: f64 = weights.iter().map(|w| w.1).sum();
        weights.iter_mut().for_each(|w| w.1 /= sum);
        if sum > 0.0 { weights } else { vec![(nearest, 1.0)] }
    }

    /// Returns the value of a node field at a point [m], in the unit of the field.
    pub fn at(&self, field: &[f64], p: [f64; 3]) -> f64 {
        self.weights(p).iter().map(|&(node, w)| w * field[node as usize]).sum()
    }
}

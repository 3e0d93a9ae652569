//! Values between the nodes of a body of cells.

use crate::mesh::cells::cell::{Cell, Wall};
use crate::mesh::cells::cell_mesh::CellMesh;
use crate::vector::{Vec3, distance, dot, sub};

/// The nodes around a point and their shares; they sum to 1.
pub type Weights = Vec<(u32, f64)>;

impl CellMesh {
    /// The node nearest to a point.
    pub fn nearest(&self, p: Vec3) -> u32 {
        self.grid.nearest(p, 0.5 * self.fineness.spacing, |_| true).unwrap_or(0)
    }

    /// Whether a point lies inside: below the surface over its nearest node.
    pub fn contains(&self, p: Vec3) -> bool {
        let node = self.nearest(p) as usize;
        let above = dot(sub(p, self.positions[node]), self.normals[node]);
        above <= self.depth[node] * (1.0 + 1e-9) + 1e-12
    }

    /// Weights with which a field is read at a point, exact for linear fields inside (Laplace weights: the faces of the cell
    /// that the point would have, over their distances).
    pub fn weights(&self, p: Vec3) -> Weights {
        let nearest = self.nearest(p);
        let gap = distance(self.positions[nearest as usize], p);
        if gap < 1e-6 * self.fineness.spacing {
            return vec![(nearest, 1.0)];
        }
        let spacing = self.fineness.spacing;
        let mut reach = 1.7 * spacing;
        let cell = loop {
            let mut cell = Cell::cube(2.0 * spacing);
            let normal = self.normals[nearest as usize];
            let plane = dot(sub(self.positions[nearest as usize], p), normal) + self.depth[nearest as usize];
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

    /// Value of a node field at a point.
    pub fn at(&self, field: &[f64], p: Vec3) -> f64 {
        self.weights(p).iter().map(|&(node, w)| w * field[node as usize]).sum()
    }
}

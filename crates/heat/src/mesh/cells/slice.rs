//! Plane sections through a body of cells.

use glam::DVec3;

use crate::mesh::bounds::bounds;
use crate::mesh::cells::cell_mesh::CellMesh;
use crate::mesh::cells::point_grid::PointGrid;
use crate::mesh::cells::weights::Weights;
use crate::mesh::section::{MeshError, Section};
use crate::mesh::surface::DepthFinder;
/// Distance of the points of a section ÷ spacing of the surface nodes [-] (chosen: two to three points in the smallest cells).
const CUT_SPACING: f64 = 0.3;

/// A plane section perpendicular to one axis, triangulated, with points in [m].
#[derive(Clone, Debug)]
pub struct CellSlice {
    /// Points [m].
    pub points: Vec<[f64; 3]>,
    /// Triangles, counter-clockwise seen from the positive end of the axis.
    pub triangles: Vec<[u32; 3]>,
    /// Lumped area of each point [m²].
    pub areas: Vec<f64>,
    /// Nodes and weights from which each point is interpolated.
    pub weights: Vec<Weights>,
}

impl CellSlice {
    /// Returns the value of a node field at a point, in the unit of the field.
    pub fn read(&self, point: usize, field: impl Fn(usize) -> f64) -> f64 {
        self.weights[point].iter().map(|&(node, w)| w * field(node as usize)).sum()
    }
}

impl CellMesh {
    /// Returns the section perpendicular to an axis (0, 1, 2) at a coordinate along it [m].
    ///
    /// # Errors
    /// [`MeshError::NoArea`] if the plane does not intersect the body.
    pub fn slice(&self, axis: usize, at: f64) -> Result<CellSlice, MeshError> {
        let finder = DepthFinder::new(&self.surface);
        let [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
        let lift = |[a, b]: [f64; 2]| {
            let mut p = DVec3::ZERO;
            (p[axis], p[u], p[v]) = (at, a, b);
            p
        };
        let spacing = CUT_SPACING * self.fineness.spacing;
        let mut grid = PointGrid::over(bounds(self.surface.points()), spacing);
        for p in self.rim(axis, at) {
            if !grid.any_within(p, 0.3 * spacing, |_| true) {
                grid.push(p);
            }
        }
        let half = self.surface.vertices.iter().fold([0.0f64; 2], |h, p| [h[0].max(p[u].abs()), h[1].max(p[v].abs())]);
        let steps = half.map(|h| libm::ceil(h / spacing) as i64);
        for j in -steps[1]..=steps[1] {
            for i in -steps[0]..=steps[0] {
                let p = lift([(i as f64 + 0.5 * (j & 1) as f64) * spacing, j as f64 * spacing]);
                if finder.depth(p).depth > 0.5 * spacing {
                    grid.push(p);
                }
            }
        }
        let points: Vec<[f64; 3]> = grid.points.iter().map(DVec3::to_array).collect();
        let flat = points.iter().map(|p| [p[u], p[v]]).collect();
        let section = Section::triangulate(flat, |c| finder.depth(lift(c)).depth > 0.0)?;
        let weights = points.iter().map(|p| self.weights(*p)).collect();
        Ok(CellSlice { points, triangles: section.triangles, areas: section.areas, weights })
    }

    /// Returns the points at which edges of the drawn surface cross a plane [m].
    fn rim(&self, axis: usize, at: f64) -> Vec<DVec3> {
        let mut rim = Vec::new();
        for t in &self.skin.triangles {
            for k in 0..3 {
                let [p, q] = [t[k], t[(k + 1) % 3]].map(|i| DVec3::from(self.skin.vertices[i as usize]));
                if (p[axis] >= at) != (q[axis] >= at) {
                    let share = (at - p[axis]) / (q[axis] - p[axis]);
                    rim.push(p + share * (q - p));
                }
            }
        }
        rim
    }
}

//! Values of node fields at points inside a piece: at its core, above and below it, anywhere.

use saute_heat::{Layout, Probe};

use crate::model::FoodModel;

impl FoodModel {
    /// Value of a node field at the core, in the unit of the field: at the rest shape's centroid, or in the middle of the
    /// thickest section of a curved body.
    pub fn at_core(&self, field: &[f64]) -> f64 {
        self.shape.core.read(field)
    }

    /// Value of a node field above or below the core, in the unit of the field: `share` runs from −1 at the lower face of
    /// the rest mesh to 1 at the upper one.
    pub fn above_core(&self, field: &[f64], share: f64) -> f64 {
        let height = 0.5 * share * self.shape.size[2];
        let probe = match self.shape.mesh.layout() {
            Layout::Upright(mesh) => {
                mesh.probe_at(&mesh.locate_or_nearest(self.shape.middle()), 0.5 * (1.0 + share) * mesh.thickness())
            }
            Layout::Along(mesh, _) => mesh.probe_at(&mesh.locate_or_nearest([0.0, height]), self.shape.core_z),
            Layout::Cells(cells) => Probe::Cells(cells.weights([0.0, 0.0, height])),
        };
        probe.read(field)
    }

    /// Value of a node field at a point of the rest mesh's frame [m], or none outside, in the unit of the field. The
    /// origin of a slice is the centroid of its bottom face.
    pub fn at(&self, field: &[f64], p: [f64; 3]) -> Option<f64> {
        self.shape.mesh.at(field, p)
    }

    /// Height of a slice's upper face above a point of its bottom face [m]; none outside, and none of other bodies.
    pub fn height_above(&self, p: [f64; 2]) -> Option<f64> {
        let Layout::Upright(mesh) = self.shape.mesh.layout() else { return None };
        let found = mesh.locate(p)?;
        Some(mesh.thickness() * mesh.column_at(&found))
    }
}

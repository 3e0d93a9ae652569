//! The inside of a piece as a grid.

use saute_kitchen::Piece;
use saute_kitchen::dynamics::Pose;
use saute_kitchen::food::FoodModel;
use saute_kitchen::heat::{BodyMesh, CellMesh, SweptMesh};

use crate::fields::corners::Corners;
use crate::fields::{array, in_kitchen, node_colours, notes};
use crate::vtk::{Array, CellKind, Cells, Grid};

/// The cells of a piece, which heating does not change.
#[derive(Clone, Debug)]
pub struct Inside {
    cells: Cells,
    /// Corners of polyhedra in the raw body [m]; none where the corners are the nodes.
    corners: Option<Vec<[f64; 3]>>,
}

impl Inside {
    /// Returns the cells of a model.
    pub fn of(model: &FoodModel) -> Self {
        match model.mesh() {
            BodyMesh::Swept(mesh) => Self { cells: wedges(mesh), corners: None },
            BodyMesh::Cells(mesh) => polyhedra(mesh),
        }
    }

    /// Returns the grid of a piece with this inside at a time [s], where a pose puts its body: every field of its nodes, on the
    /// points of wedges or on polyhedra.
    pub fn grid(&self, piece: &Piece, pose: &Pose, time_s: f64) -> Grid {
        let (model, state) = (&piece.model, &piece.state);
        let mut fields: Vec<Array> = model.node_fields(state).into_iter().map(array).collect();
        fields.push(Array::colours("colour_srgb", &node_colours(piece)));
        fields.push(Array::flags("half", (0..model.mesh().node_count()).map(|node| model.is_beyond_cut(node))));
        let grid = Grid { cells: self.cells.clone(), time_s, notes: notes(piece), ..Grid::default() };
        match &self.corners {
            None => {
                let rest: Vec<[f64; 3]> =
                    (0..model.mesh().node_count()).map(|node| model.rest_position(node)).collect();
                fields.push(Array::vectors("rest_m", "m", &rest));
                let points = in_kitchen(model.positions(state).into_iter(), pose);
                Grid { points, of_points: fields, ..grid }
            }
            Some(corners) => {
                let now = corners.iter().map(|p| p.map(|v| v * state.stretch.lateral));
                let of_points = vec![Array::vectors("rest_m", "m", corners)];
                Grid { points: in_kitchen(now, pose), of_points, of_cells: fields, ..grid }
            }
        }
    }
}

/// A wedge between two levels on each triangle of the section; both triangles turn about the way to the second, as readers
/// expect it for a positive volume.
fn wedges(mesh: &SweptMesh) -> Cells {
    let mut cells = Cells::default();
    for level in 0..mesh.levels.len().saturating_sub(1) {
        for &[a, b, c] in &mesh.section.triangles {
            let at = |level: usize| [a, b, c].map(|i| mesh.node(level, i as usize));
            cells.push(CellKind::Wedge, at(level).into_iter().chain(at(level + 1)));
        }
    }
    cells
}

/// The cell of each node.
fn polyhedra(mesh: &CellMesh) -> Inside {
    let (mut cells, mut corners) = (Cells::default(), Corners::new(mesh.fineness.spacing));
    for node in 0..mesh.node_count() {
        let faces: Vec<Vec<u32>> =
            mesh.cell_faces(node).iter().filter_map(|polygon| corners.polygon(polygon)).collect();
        cells.push_polyhedron(&faces);
    }
    Inside { cells, corners: Some(corners.points) }
}

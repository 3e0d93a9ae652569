//! The surface of a piece as a grid of triangles.

use saute_kitchen::Piece;
use saute_kitchen::dynamics::Pose;
use saute_kitchen::food::Touch;
use saute_kitchen::heat::{BodyMesh, CellMesh};

use crate::fields::{in_kitchen, node_colours, notes};
use crate::vtk::{Array, CellKind, Cells, Grid};

/// Returns the surface of a piece at a time [s], where a pose puts its body: the fields that hold at a point, and what only a
/// surface has. Faces that a knife has made are not in it.
pub fn surface(piece: &Piece, pose: &Pose, time_s: f64) -> Grid {
    let grid = match piece.model.mesh() {
        BodyMesh::Swept(_) => over_patches(piece, pose),
        BodyMesh::Cells(mesh) => over_skin(piece, mesh, pose),
    };
    Grid { time_s, notes: notes(piece), ..grid }
}

/// The triangles over the patches: two at one node where two faces meet, so that each has its own normal and contact.
fn over_patches(piece: &Piece, pose: &Pose) -> Grid {
    let (model, state) = (&piece.model, &piece.state);
    let skin = ..model.fresh_faces().start;
    let nodes: Vec<usize> = model.patches()[skin].iter().map(|patch| patch.node as usize).collect();
    let positions = model.positions(state);
    let mut of_points = at_points(piece, &|field| nodes.iter().map(|node| field[*node]).collect());
    let colours = node_colours(piece);
    let colours: Vec<[u8; 3]> = nodes.iter().map(|node| colours[*node]).collect();
    let normals = model.patch_geometry(state);
    let normals = normals[skin].iter().map(|patch| pose.rotation.mul_vec3(patch.normal.into()).to_array());
    of_points.push(Array::colours("colour_srgb", &colours));
    of_points.push(Array::vectors("normal", "", &normals.collect::<Vec<_>>()));
    of_points.extend(contacts(piece, nodes.len()));
    let areas = (0..nodes.len()).map(|patch| piece.patch_area(patch)).collect();
    of_points.push(Array::reals("area_m2", "m²", areas));
    let points = in_kitchen(nodes.iter().map(|node| positions[*node]), pose);
    Grid { points, cells: triangles(&model.surface().patches), of_points, ..Grid::default() }
}

/// The drawn surface of a body of cells, whose vertices read the nodes around them.
fn over_skin(piece: &Piece, mesh: &CellMesh, pose: &Pose) -> Grid {
    let skin = &mesh.skin;
    let read = |field: &[f64]| (0..skin.vertices.len()).map(|vertex| skin.read(vertex, field)).collect::<Vec<f64>>();
    let mut of_points = at_points(piece, &read);
    let colours = node_colours(piece);
    let channel = |k: usize| read(&colours.iter().map(|colour| f64::from(colour[k])).collect::<Vec<f64>>());
    let [r, g, b] = [0, 1, 2].map(channel);
    let mixed: Vec<[u8; 3]> = (0..r.len()).map(|v| [r[v], g[v], b[v]].map(|c| c.round() as u8)).collect();
    let normals = skin.normals.iter().map(|normal| pose.rotation.mul_vec3((*normal).into()).to_array());
    of_points.push(Array::colours("colour_srgb", &mixed));
    of_points.push(Array::vectors("normal", "", &normals.collect::<Vec<_>>()));
    let lateral = piece.state.stretch.lateral;
    let points = in_kitchen(skin.vertices.iter().map(|p| p.map(|v| v * lateral)), pose);
    Grid { points, cells: triangles(&skin.triangles), of_points, ..Grid::default() }
}

/// Fields that hold at a point, each read there.
fn at_points(piece: &Piece, read: &dyn Fn(&[f64]) -> Vec<f64>) -> Vec<Array> {
    let fields = piece.model.node_fields(&piece.state).into_iter().filter(|field| !field.is_amount);
    let mut arrays: Vec<Array> = fields.map(|f| Array::reals(f.name, f.unit, read(&f.values))).collect();
    arrays.push(Array::reals("juice_film", "", read(&piece.model.juice_films(&piece.state))));
    let lines = piece.sear_strength();
    let none = vec![0.0; piece.model.mesh().node_count()];
    arrays.push(Array::reals("sear_lines", "", read(if lines.is_empty() { &none } else { &lines })));
    arrays
}

/// Conductance to what a patch touches and the temperature of that; 0 and NaN where it touches nothing.
fn contacts(piece: &Piece, patches: usize) -> [Array; 2] {
    let touch = |patch: usize| piece.touches().get(patch).copied().unwrap_or_default();
    let temperature = |touch: Touch| {
        let there = touch.conductance() > 0.0;
        if there { saute_kitchen::celsius(touch.temperature()) } else { f64::NAN }
    };
    let (conductances, temperatures) = (0..patches).map(touch).map(|t| (t.conductance(), temperature(t))).unzip();
    [Array::reals("contact_w_m2k", "W/(m²·K)", conductances), Array::reals("contact_temperature_c", "°C", temperatures)]
}

fn triangles(corners: &[[u32; 3]]) -> Cells {
    let mut cells = Cells::default();
    corners.iter().for_each(|t| cells.push(CellKind::Triangle, t.map(|corner| corner as usize)));
    cells
}

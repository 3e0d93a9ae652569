//! The fields of a kitchen and of a lab's body as grids.
//!
//! A piece has two grids: its inside ([`Inside`]), on whose nodes or cells every field of its state is given, and its surface
//! ([`surface`]) with what only a surface has. Points are in the kitchen's frame, z upwards; `rest_m` gives where they were in the raw
//! body. A body of swept sections is made of wedges with its nodes at their corners; a body from a surface file is made of
//! polyhedra, one for each node. The lab's bodies are products of axes ([`product`]).

mod corners;
pub mod inside;
pub mod pan;
pub mod product;
pub mod surface;

use saute_kitchen::Piece;
use saute_kitchen::dynamics::Pose;
use saute_kitchen::food::NodeField;

use crate::vtk::Array;

pub use inside::Inside;

/// Returns a field as an array of the nodes.
pub fn array(field: NodeField<'_>) -> Array {
    Array::reals(field.name, field.unit, field.values.into_owned())
}

/// Colour of the flesh at each node, 8-bit sRGB.
fn node_colours(piece: &Piece) -> Vec<[u8; 3]> {
    (0..piece.model.mesh().node_count()).map(|node| piece.model.node_colour(&piece.state, node).srgb8()).collect()
}

/// Notes about the grids of a piece.
fn notes(piece: &Piece) -> Vec<(&'static str, String)> {
    vec![
        ("food", piece.id.clone()),
        ("kind", piece.kind.clone()),
        ("place", piece.place.name().to_owned()),
        ("program", concat!("saute ", env!("CARGO_PKG_VERSION")).to_owned()),
    ]
}

/// Points of a body's frame in the kitchen [m].
fn in_kitchen(points: impl Iterator<Item = [f64; 3]>, pose: &Pose) -> Vec<[f64; 3]> {
    points.map(|p| pose.to_world(p.into()).to_array()).collect()
}

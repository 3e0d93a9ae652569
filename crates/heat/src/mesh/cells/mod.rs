//! Volume meshes inside closed surfaces: cells around nodes, each cell what lies nearest to its node.
//!
//! Nodes lie on the surface, in layers below it and on a lattice inside. The face between two cells stands upright on
//! the line that joins their nodes, so that face over distance conducts a linear field exactly and is never negative.

mod cell;
mod cell_mesh;
mod layer;
mod point_grid;
mod sample;
mod skin;
mod slice;
mod weights;

pub use cell_mesh::{CellMesh, CellMeshError, CellPatch, Fineness};
pub use skin::Skin;
pub use slice::CellSlice;
pub use weights::Weights;

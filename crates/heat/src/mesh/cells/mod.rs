//! Voronoi meshes inside closed surfaces: each node's control volume is its Voronoi cell, cut off at the surface.
//!
//! Nodes lie on the surface, in layers below it, and on a lattice inside. A Voronoi face is perpendicular to the line
//! between its two nodes. The two-point flux with face area ÷ distance is therefore exact for linear fields and never has a
//! negative weight, so explicit steps obey the maximum principle.

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

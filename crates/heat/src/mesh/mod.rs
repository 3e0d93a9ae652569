//! Meshes: cross-sections swept along a path, cells inside a closed surface, and the surfaces themselves.

pub mod body_mesh;
pub mod cells;
pub mod cut;
pub mod levels;
pub mod locate;
pub mod outline;
pub mod path;
pub mod probe;
pub mod section;
pub mod surface;
pub mod swept;
mod swept_probe;
mod swept_surface;

//! Meshes: cross-sections swept along a path, cells inside a closed surface, and the surfaces themselves.

pub mod cells;
pub mod cut;
pub mod levels;
pub mod locate;
pub mod outline;
pub mod path;
pub mod section;
pub mod surface;
pub mod swept;

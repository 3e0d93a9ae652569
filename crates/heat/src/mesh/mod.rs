//! Meshes: cross-sections swept along a path, Voronoi cells inside a closed surface, and closed surfaces.

mod bounds;
pub mod cells;
pub mod cut;
pub mod levels;
pub mod locate;
pub mod outline;
pub mod path;
pub mod section;
pub mod surface;
pub mod swept;

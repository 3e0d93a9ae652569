//! Faces that a cut lays open, in the scene and as separate pictures.

pub(crate) mod contour;
pub(crate) mod face;
pub(crate) mod path;
pub(crate) mod rim;
pub mod section;
pub(crate) mod steps;

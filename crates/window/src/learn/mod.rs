//! The result of a cook as a picture of its own, drawn without the window.

pub mod on_its_own;
pub mod raster;

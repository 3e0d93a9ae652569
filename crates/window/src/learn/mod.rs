//! What the window teaches: goals, the result of a cook, skill mode, and the tutorial.

pub mod on_its_own;
pub mod raster;

//! What is painted with pipelines or shapes of its own inside egui's pass.

pub mod ground;
pub mod hatch;
pub mod scene;

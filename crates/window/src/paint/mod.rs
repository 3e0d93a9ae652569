//! What is painted with pipelines or shapes of its own inside egui's pass.

mod damage;
pub mod ground;
pub mod hatch;
pub mod panel_layer;
pub mod scene;

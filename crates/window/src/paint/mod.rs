//! What is painted with separate pipelines or shapes inside egui's pass.

mod damage;
pub mod ground;
pub mod hatch;
pub mod panel_layer;
pub mod scene;

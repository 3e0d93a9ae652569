//! The 3-D picture: pan, hob, board and food, drawn with wgpu.

pub mod camera;
pub mod input;

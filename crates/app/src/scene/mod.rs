//! The 3-D picture: pan, hob, board and food, drawn with wgpu.

pub mod callback;
pub mod camera;
mod dirty;
mod environment;
mod food_gpu;
mod fry;
pub mod ground;
pub mod input;
mod lid_mesh;
mod mesh;
mod noise;
pub(crate) mod overlay;
pub(crate) mod pan_mesh;
mod passes;
mod pipelines;
pub mod props;
pub mod quality;
pub(crate) mod readback;
pub mod renderer;
mod rest_mesh;
mod room_light;
pub mod sample;
mod shadow;
mod shown;
mod solid_gpu;
mod spatter;
mod sprite_gpu;
mod steam;
mod still;
pub mod string_mesh;
mod targets;
#[cfg(test)]
mod tests;
mod textures;
mod tool_mesh;
mod uniforms;
pub mod white_balance;

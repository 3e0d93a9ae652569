//! The renderer: pan, hob, board and food drawn with wgpu from one plain description.
//!
//! [`input::SceneInput`] describes everything in the picture; [`renderer::SceneRenderer`] draws it into a texture of its
//! own. The crate knows no kitchen and no window.

pub mod camera;
pub mod gpu;
pub mod input;
pub mod light;
pub mod mesh;
mod noise;
pub mod quality;
pub mod renderer;
pub mod sample;
#[cfg(test)]
mod tests;

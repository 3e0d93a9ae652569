//! The renderer: pan, hob, board and food drawn with wgpu from one plain description.
//!
//! [`input::SceneInput`] describes everything in a picture; [`renderer::SceneRenderer`] draws it into a texture of its
//! own. The crate depends on no kitchen and no window. Lengths are in metres, colours in linear sRGB unless stated.
//!
//! The camera circles a target, which appears in the middle of the picture:
//!
//! ```
//! use saute_scene::camera::Camera;
//!
//! let camera = Camera::three_quarter();
//! // Normalised device coordinates of the target in a picture of 16:9 [-].
//! let at = camera.project(camera.target, 16.0 / 9.0).expect("in front of the camera");
//! assert!(at[0].abs() < 1e-4 && at[1].abs() < 1e-4);
//! // Distance from the camera to its target [m].
//! assert!((camera.eye().distance(camera.target) - camera.distance).abs() < 1e-5);
//! ```

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

//! The renderer: pan, hob, board and food drawn with wgpu from one plain description.
//!
//! [`input::SceneInput`] describes everything in a picture; [`renderer::SceneRenderer`] draws it into a texture of its
//! own. The crate depends on no kitchen and no window. Lengths are in metres, colours in linear sRGB unless stated.
//!
//! Flesh is coloured per fragment: a solid texture, one for each kind of tissue, varies state and colour about their
//! means by rest position, so that a cut shows the inside of what the surface shows. `flesh.wgsl` repeats the colour
//! model of the core; validation reads both. Field views look a coordinate up in a table of 256 colours per fragment,
//! so flat pictures decode to the core's temperatures within 1 K. Steam, smoke and flames are sprites whose visible
//! mass is proportional to the flow.
//!
//! Static content is kept as a picture with depth; each frame redraws only what moves. Quality has three levels:
//! quick keeps static content, smooth has four samples per pixel, best adds finer maps and textures and the contact
//! shadow of food. Except on OpenGL and WebGL2, best draws the look as radiances in half floats and develops them:
//! ambient occlusion from the depth, light that scatters in flesh, depth of field, bloom, vignette, tone curve. Fields,
//! flat pictures and the half mirror pass none of this. The light of the room, by day or in the evening, is defined once,
//! in Rust, for shaders and white balance. White balance scales the look in linear sRGB and leaves fields and flat
//! pictures unchanged. A picture larger than the device draws at once is drawn in tiles.
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

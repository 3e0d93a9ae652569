//! Stills without a window: the graphics device, pictures of recipes, and colours measured on them.

#[cfg(not(target_arch = "wasm32"))]
pub mod animation;
#[cfg(not(target_arch = "wasm32"))]
pub mod headless;
pub mod png_file;
#[cfg(not(target_arch = "wasm32"))]
pub mod series;
#[cfg(not(target_arch = "wasm32"))]
pub mod shot;

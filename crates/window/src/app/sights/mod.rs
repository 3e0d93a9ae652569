//! What is seen: the scene, the eye, ways side by side, pictures, the half mirror.

mod glance;
mod mirror;
#[cfg(not(target_arch = "wasm32"))]
mod photo;
mod pose;
mod quality;
mod save_picture;
mod scene_view;
mod ways_view;

//! The half mirror: food that seems to lie in a real pan.

pub mod aim;
pub mod calibration;
pub mod frame;
pub mod keystone;
pub mod lens;
pub mod optics;
pub mod pattern;
pub mod presenter;
pub mod registration;
pub mod rig;
pub mod rig_file;
pub mod screen;
pub mod settings;
#[cfg(test)]
mod simulated_rig;
pub mod stereo;
#[cfg(not(target_arch = "wasm32"))]
pub mod still;
pub mod view;
pub mod warp;

//! The half mirror: food that seems to lie in a real pan.
//!
//! A rig gives the virtual image of the screen in the half mirror. The eye looks through that image off-axis, and a
//! last pass corrects keystone and lens distortion per pixel. Room, hob and pan are left out of the picture; the pan
//! remains as a black occluder. Calibration along the rays of the eye replaces all measured values but the positions
//! of the eye and the sheet.

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

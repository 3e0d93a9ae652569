//! The half mirror: the geometry by which food appears in a real pan.
//!
//! A rig ([`rig`], read by [`rig_file`]) gives the virtual image of the screen in the half mirror. The eye looks through that image
//! off-axis ([`optics`]), and a last pass corrects keystone and lens distortion per pixel ([`warp`]). Calibration along the rays of the
//! eye ([`calibration`]) replaces all measured values but the positions of the eye and the sheet. This crate draws nothing and opens no
//! file.

pub mod calibration;
pub mod keystone;
pub mod lens;
pub mod optics;
pub mod options;
pub mod registration;
pub mod rig;
pub mod rig_file;
pub mod screen;
pub mod settings;
#[cfg(test)]
mod simulated_rig;
pub mod stereo;
pub mod warp;

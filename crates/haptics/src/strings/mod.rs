//! String-driven devices: geometry, tension distribution, pose estimation, calibration and the SPIDAR driver.

pub mod geometry;
pub mod jig_calibration;
mod jig_log;
pub mod kept_calibration;
mod linear;
pub mod pose_from_lengths;
pub mod simulator;
pub mod spidar;
mod string_rig;
pub mod tension;
pub mod wire;
pub mod workspace;

pub use string_rig::{Lines, STRINGS, StringRig};

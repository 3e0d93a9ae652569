//! String-driven devices: geometry, tension distribution, pose estimation, calibration and the SPIDAR driver.

mod caps_verdict;
mod device_clock;
pub mod geometry;
pub mod jig_calibration;
mod jig_log;
pub mod kept_calibration;
mod linear;
mod locator;
pub mod pose_from_lengths;
mod pull;
mod session;
pub mod simulator;
pub mod spidar;
mod stops;
mod string_rig;
pub mod tension;
pub mod wire;
pub mod workspace;

pub use caps_verdict::LAWFUL_WATCHDOG_MS;
pub use string_rig::{Lines, STRINGS, StringRig};

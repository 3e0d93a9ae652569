//! What the driver of string devices promises: poses, tensions, calibration, protocol, and what a hand feels.

// A test that unwraps in vain says where.
#![allow(clippy::unwrap_used)]

mod bench_device;
mod calibration;
mod control_loop;
mod degrade;
mod driver;
mod feel;
mod geometry_file;
mod hands;
mod kept_calibration;
mod kitchen;
mod pose;
mod random;
mod tension;
mod wire;

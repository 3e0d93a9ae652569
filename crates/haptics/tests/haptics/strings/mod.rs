//! What string devices promise: poses, tensions, calibration and the wire protocol.

mod calibration;
mod caps;
mod driver;
mod geometry_file;
mod hostile_device;
mod impossible_data;
mod kept_calibration;
mod pose;
mod tension;
mod wire;

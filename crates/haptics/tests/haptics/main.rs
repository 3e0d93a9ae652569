//! What haptic devices promise: string devices, the control loop, networked devices and the link to the kitchen.

// A failed unwrap in a test names its line.
#![allow(clippy::unwrap_used)]

mod allocation;
mod bench_caps;
mod bench_device;
mod control;
#[cfg(unix)]
mod ending;
mod kitchen;
mod name_before_file;
mod random;
mod remote;
mod strings;

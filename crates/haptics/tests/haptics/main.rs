//! What haptic devices promise: string devices, the control loop, networked devices and the link to the kitchen.

// A failed unwrap in a test names its line.
#![allow(clippy::unwrap_used)]

#[path = "../bench_caps/mod.rs"]
mod bench_caps;
mod bench_device;
mod control;
mod kitchen;
mod random;
mod remote;
mod strings;

//! What haptic devices promise: string devices, the control loop, networked devices and the link to the kitchen.

// A test that unwraps in vain says where.
#![allow(clippy::unwrap_used)]

mod bench_device;
mod control;
mod kitchen;
mod random;
mod remote;
mod strings;

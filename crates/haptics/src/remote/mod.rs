//! Networked devices: phones, the Haply Inverse3 and OSC senders, with pairing and rate limits.
//!
//! Devices on a network run their own threads and hand over by triple buffer. A wrench becomes a force, rumble, or
//! sound and picture by the fixed rules of one module for devices that cannot render it.

#[cfg(not(target_arch = "wasm32"))]
mod allowance;
#[cfg(not(target_arch = "wasm32"))]
mod bounded;
#[cfg(not(target_arch = "wasm32"))]
pub mod haply;
#[cfg(not(target_arch = "wasm32"))]
mod inbox;
#[cfg(not(target_arch = "wasm32"))]
pub mod network_thread;
#[cfg(not(target_arch = "wasm32"))]
pub mod osc;
#[cfg(not(target_arch = "wasm32"))]
pub mod pairing;
pub mod phone;
#[cfg(not(target_arch = "wasm32"))]
mod reachable;
mod remote_pose;
pub mod tilt;
#[cfg(not(target_arch = "wasm32"))]
mod timeout;

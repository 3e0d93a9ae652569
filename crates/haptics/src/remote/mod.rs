//! Networked devices: phones, the Haply Inverse3 and OSC senders, with pairing and rate limits.
//!
//! Devices on a network run their own threads and hand over by triple buffer. A wrench becomes a force, rumble, or
//! sound and picture by the fixed rules of one module for devices that cannot render it.

mod allowance;
mod bounded;
pub mod haply;
mod inbox;
pub mod network_thread;
pub mod osc;
pub mod pairing;
pub mod phone;
mod reachable;
mod remote_pose;
pub mod tilt;
mod timeout;

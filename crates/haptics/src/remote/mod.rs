//! Networked devices: phones, the Haply Inverse3 and OSC senders, with pairing and rate limits.

mod allowance;
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

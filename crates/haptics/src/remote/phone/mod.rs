//! A phone as a pan: its page sends orientation and acceleration over TLS, after pairing with the code on the screen.

#[cfg(not(target_arch = "wasm32"))]
mod certificate;
pub mod held_pan;
pub mod held_phone;
#[cfg(not(target_arch = "wasm32"))]
pub mod http;
pub mod message;
pub mod orientation;
#[cfg(not(target_arch = "wasm32"))]
mod phone_device;
#[cfg(not(target_arch = "wasm32"))]
mod server;
#[cfg(not(target_arch = "wasm32"))]
mod session;
#[cfg(not(target_arch = "wasm32"))]
mod slots;
pub mod toss;
#[cfg(not(target_arch = "wasm32"))]
mod waiting_room;

#[cfg(not(target_arch = "wasm32"))]
pub use phone_device::{Incoming, Outgoing, PHONE, Phone, capabilities, open};

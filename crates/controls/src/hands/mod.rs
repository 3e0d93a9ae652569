//! Hands at devices: what they hold, and what they do to the kitchen in every frame.

#[cfg(not(target_arch = "wasm32"))]
mod connected;
#[cfg(not(target_arch = "wasm32"))]
mod devices;
#[cfg(not(target_arch = "wasm32"))]
mod gamepad_device;
#[cfg(target_arch = "wasm32")]
mod phone;
pub mod role;

#[cfg(not(target_arch = "wasm32"))]
pub use self::connected::{ConnectError, Connected};
#[cfg(not(target_arch = "wasm32"))]
pub use self::devices::{Hands, HandsStart};
#[cfg(not(target_arch = "wasm32"))]
pub use self::gamepad_device::GamepadDevice;
#[cfg(target_arch = "wasm32")]
pub use self::phone::{Hands, reading};
pub use self::role::Role;

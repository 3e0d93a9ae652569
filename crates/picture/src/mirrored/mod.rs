//! The half mirror's picture: the scene as each eye sees it, warped to the device.

pub mod frame;
pub mod presenter;
#[cfg(not(target_arch = "wasm32"))]
pub mod still;

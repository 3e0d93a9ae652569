//! What only a desktop, or only a page, lets a person do.

#[cfg(target_arch = "wasm32")]
pub use crate::browser::act::HostAct;
#[cfg(not(target_arch = "wasm32"))]
pub use crate::desktop::act::HostAct;

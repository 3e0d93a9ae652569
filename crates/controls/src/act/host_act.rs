//! What only a desktop, or only a page, lets a person do.

#[cfg(not(target_arch = "wasm32"))]
pub use super::desktop_act::HostAct;
#[cfg(target_arch = "wasm32")]
pub use super::page_act::HostAct;

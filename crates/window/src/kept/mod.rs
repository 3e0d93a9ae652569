//! What outlasts the window: files, links, the cook that goes on, settings.

pub mod autosave;
#[cfg(not(target_arch = "wasm32"))]
pub(crate) mod files;
pub mod link;
pub(crate) mod remembered;
#[cfg(not(target_arch = "wasm32"))]
pub mod session_file;

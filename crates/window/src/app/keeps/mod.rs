//! What outlasts a frame: files, links, the cook that is kept, acts that wait, and the system's window.

mod autosave;
#[cfg(not(target_arch = "wasm32"))]
mod cook_file;
#[cfg(not(target_arch = "wasm32"))]
mod files;
mod link;
mod waiting;
#[cfg(not(target_arch = "wasm32"))]
mod window;

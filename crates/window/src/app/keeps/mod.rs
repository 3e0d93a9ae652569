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

use std::sync::Arc;

use saute_kitchen::Library;

/// What outlasts the window.
pub(crate) struct Keeps {
    /// The library with which the program was started.
    pub(crate) library: Arc<Library>,
    /// The folder of pictures, if it is not the user's.
    #[cfg(not(target_arch = "wasm32"))]
    pub(crate) pictures: Option<std::path::PathBuf>,
    /// The file dialog while it is open.
    #[cfg(not(target_arch = "wasm32"))]
    pub(crate) dialog: crate::kept::files::Dialog,
    /// The cook that goes on, as it is kept.
    pub(crate) autosave: crate::kept::autosave::Autosave,
}

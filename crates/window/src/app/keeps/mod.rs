//! What outlasts a frame: links, the cook that is kept, and acts that wait.

mod autosave;
mod building;
pub(crate) mod later;
mod link;
mod waiting;

use std::sync::Arc;

use saute_kitchen::Library;

/// What outlasts the window.
pub(crate) struct Keeps {
    /// The library with which the program was started.
    pub(crate) library: Arc<Library>,
    /// The cook that goes on, as it is kept.
    pub(crate) autosave: saute_session::kept::autosave::Autosave,
}

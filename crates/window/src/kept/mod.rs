//! What outlasts the window: files, links, the cook that goes on, settings.

pub mod autosave;
pub mod link;
pub(crate) mod remembered;

//! Why a folder cannot be used.

use std::io;
use std::path::Path;

/// A folder that cannot be used, with the remedy.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{place}: {message}; {remedy}")]
pub struct FolderError {
    /// The folder or file.
    pub place: String,
    /// What is wrong.
    pub message: String,
    /// How to correct it.
    pub remedy: String,
}

impl FolderError {
    pub(crate) fn new(place: &Path, message: impl Into<String>, remedy: impl Into<String>) -> Self {
        Self { place: place.display().to_string(), message: message.into(), remedy: remedy.into() }
    }

    pub(crate) fn io(place: &Path, error: &io::Error) -> Self {
        let remedy = match error.kind() {
            io::ErrorKind::StorageFull | io::ErrorKind::QuotaExceeded => {
                "free some space and start it again: it goes on where it was"
            }
            io::ErrorKind::ResourceBusy => "wait until it has ended, or name another folder",
            _ => "name a folder with write permission",
        };
        Self::new(place, format!("cannot be written: {error}"), remedy)
    }
}

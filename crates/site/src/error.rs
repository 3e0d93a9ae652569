//! What can go wrong while the site is made or served.

use std::io;
use std::path::{Path, PathBuf};

/// An error with the remedy in its text.
#[derive(Debug, thiserror::Error)]
pub enum SiteError {
    /// A file cannot be read or written.
    #[error("{path}: {source}")]
    File {
        /// Which file.
        path: PathBuf,
        /// Why.
        source: io::Error,
    },
    /// wasm-bindgen refuses the module.
    #[error("wasm-bindgen: {0}")]
    Bind(String),
    /// The module of the sound is not what a worklet can take.
    #[error("{path}: {reason}")]
    Sound {
        /// Its file.
        path: PathBuf,
        /// What is wrong.
        reason: String,
    },
    /// wasm-opt failed.
    #[error("{program}: {reason}")]
    Optimise {
        /// The program that was called.
        program: PathBuf,
        /// Its words.
        reason: String,
    },
    /// A link of a guide leads nowhere.
    #[error("{page}: the link ({target}) leads nowhere")]
    Link {
        /// The Markdown file.
        page: PathBuf,
        /// The target of the link.
        target: String,
    },
    /// The page has become too large.
    #[error("the page sends {sent} bytes before the first interaction; at most {most} are allowed")]
    TooLarge {
        /// Bytes with brotli.
        sent: u64,
        /// The budget.
        most: u64,
    },
    /// The port cannot be opened.
    #[error("127.0.0.1:{port}: {source}; choose another port with --port")]
    Port {
        /// The port.
        port: u16,
        /// Why.
        source: io::Error,
    },
}

/// Names the file in an error of the file system.
pub fn at(path: &Path) -> impl FnOnce(io::Error) -> SiteError {
    move |source| SiteError::File { path: path.to_owned(), source }
}

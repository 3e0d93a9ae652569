//! What is wrong with a file of the user's.

/// A file that cannot be used: where, what is wrong, and what to write instead.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{file}:{line}: {message}\n  remedy: {remedy}")]
pub struct InputError {
    /// Which file.
    pub file: String,
    /// Line, from 1.
    pub line: usize,
    /// What is wrong, with the key.
    pub message: String,
    /// What to write instead.
    pub remedy: String,
}

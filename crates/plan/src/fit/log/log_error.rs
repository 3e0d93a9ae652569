//! Why a log cannot be read.

use super::times::TimeForm;
use super::unit::Unit;

/// A reason for which a log cannot be read.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{file}:{line}: {message}; {remedy}")]
pub struct LogError {
    /// Name of the file.
    pub file: String,
    /// Line, from 1.
    pub line: u64,
    /// What is wrong.
    pub message: String,
    /// What to do about it.
    pub remedy: String,
    /// What would have to be known, where two readings are possible.
    pub question: Option<Question>,
}

/// What a log does not state.
#[derive(Clone, Debug, PartialEq)]
pub enum Question {
    /// The unit of the temperatures.
    Unit([Unit; 2]),
    /// What the times are.
    Times(Vec<TimeForm>),
    /// Which column is the core's.
    Core(Vec<usize>),
    /// Which column is the pan's.
    Pan(Vec<usize>),
}

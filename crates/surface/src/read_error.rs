//! The reason why a surface file cannot be read.

use std::fmt::{Display, Formatter};

/// The place in a file at which its reader stopped.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// The file as a whole, or a part that the message names.
    File,
    /// A line of a text, from 1.
    Line(usize),
    /// A byte of a binary file, from 0.
    Byte(usize),
}

impl Display for Place {
    fn fmt(&self, f: &mut Formatter) -> std::fmt::Result {
        match self {
            Self::File => Ok(()),
            Self::Line(number) => write!(f, "line {number}: "),
            Self::Byte(number) => write!(f, "byte {number}: "),
        }
    }
}

/// The reason why a surface file cannot be read, with a remedy for the user.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{place}{message}")]
pub struct ReadError {
    /// The place in the file.
    pub place: Place,
    /// The problem, as a predicate of the place.
    pub message: String,
    /// The remedy, as an instruction.
    pub remedy: String,
}

impl ReadError {
    pub(crate) fn new(message: impl Into<String>, remedy: impl Into<String>) -> Self {
        Self { place: Place::File, message: message.into(), remedy: remedy.into() }
    }

    pub(crate) fn at_line(number: usize, message: impl Into<String>, remedy: impl Into<String>) -> Self {
        Self { place: Place::Line(number), ..Self::new(message, remedy) }
    }

    pub(crate) fn at_byte(number: usize, message: impl Into<String>, remedy: impl Into<String>) -> Self {
        Self { place: Place::Byte(number), ..Self::new(message, remedy) }
    }
}

/// The remedy for files that are too large.
pub(crate) const TOO_LARGE: &str =
    "export only the body, and reduce the number of its triangles in your modelling program (decimate)";

/// The remedy for files that are damaged or misnamed.
pub(crate) const DAMAGED: &str = "export it again; the file is damaged, or its extension does not match its format";

/// The remedy for files that end too soon.
pub(crate) const CUT_OFF: &str = "copy, download or export it again; its end is missing";

//! One row of a sweep: how it ended and its numbers.

use saute_formats::Value;
use serde::{Deserialize, Serialize};

/// How a row ended.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq, Serialize)]
pub enum Status {
    /// The recipe ended.
    Done,
    /// The recipe's `max_s` ended it.
    MaxS,
    /// The sweep's `for_s` ended it.
    ForS,
    /// It could not be cooked; the message states why.
    Failed,
}

impl Status {
    /// Returns the status as the column `status` has it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Done => "done",
            Self::MaxS => "max_s",
            Self::ForS => "for_s",
            Self::Failed => "failed",
        }
    }
}

/// The result of one row.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct RowResult {
    /// Number of the row, from 0.
    pub row: u64,
    /// How it ended.
    pub status: Status,
    /// Why it failed; none if it did not.
    pub message: Option<String>,
    /// Varied values, in the order of the file.
    pub varied: Vec<Value>,
    /// Numbers of the summary, in the order of the sweep's columns.
    pub numbers: Vec<Option<Value>>,
}

impl RowResult {
    /// Returns the result as bytes, in which every bit of every number is kept.
    pub fn to_bytes(&self) -> Vec<u8> {
        // Numbers, texts and lists of them always have bytes.
        postcard::to_allocvec(self).unwrap_or_default()
    }

    /// Reads a result from bytes; none if they are not those of a result.
    pub fn from_bytes(bytes: &[u8]) -> Option<Self> {
        postcard::from_bytes(bytes).ok()
    }
}

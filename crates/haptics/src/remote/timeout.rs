//! Reads that end without a word.

use std::io::{Error, ErrorKind};

/// Whether nothing has come yet, as systems say it after a read's patience.
pub fn is_timeout(error: &Error) -> bool {
    matches!(error.kind(), ErrorKind::WouldBlock | ErrorKind::TimedOut | ErrorKind::Interrupted)
}

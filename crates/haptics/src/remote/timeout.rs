//! Read timeouts.

use std::io::{Error, ErrorKind};

/// Returns true if a read ended without data: the systems report a timeout in three ways.
pub fn is_timeout(error: &Error) -> bool {
    matches!(error.kind(), ErrorKind::WouldBlock | ErrorKind::TimedOut | ErrorKind::Interrupted)
}

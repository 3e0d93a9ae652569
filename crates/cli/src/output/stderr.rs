//! Messages on stderr; all of them go through this file.

use std::io::Write;

use crate::output::printable::printable;

/// Prints a line to stderr. A closed pipe is not an error.
pub fn say(text: impl std::fmt::Display) {
    let _ = writeln!(std::io::stderr(), "{}", printable(&text.to_string()));
}

//! Messages go to stderr, and only through here.

use std::io::Write;

/// Says something. A reader that has gone away is not an error.
pub fn say(text: impl std::fmt::Display) {
    let _ = writeln!(std::io::stderr(), "{text}");
}

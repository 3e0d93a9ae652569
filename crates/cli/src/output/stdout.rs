//! Data for people and programs goes to stdout, and only through here.

use std::io::{ErrorKind, Write};

use crate::error::CliError;

/// Writes a text to stdout. A reader that has seen enough (`saute list pans | head -1`) is not an error.
pub fn print(text: &str) -> Result<(), CliError> {
    let mut out = std::io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(e) if e.kind() != ErrorKind::BrokenPipe => Err(CliError::place(
            "stdout",
            format!("cannot be written: {e}"),
            "write to another place or free some space",
        )),
        _ => Ok(()),
    }
}

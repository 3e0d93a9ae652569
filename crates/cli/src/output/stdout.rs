//! Results on stdout; all of them go through this file.

use std::io::{ErrorKind, Write};

use crate::error::CliError;
use crate::output::printable::printable;

/// Prints a text to stdout. A closed pipe (`saute list pans | head -1`) is not an error.
pub fn print(text: &str) -> Result<(), CliError> {
    let mut out = std::io::stdout().lock();
    match out.write_all(printable(text).as_bytes()).and_then(|()| out.flush()) {
        Err(e) if e.kind() != ErrorKind::BrokenPipe => Err(CliError::place(
            "stdout",
            format!("cannot be written: {e}"),
            "redirect to another place or free some space",
        )),
        _ => Ok(()),
    }
}

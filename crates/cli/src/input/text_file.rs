//! Text files.

use std::path::Path;

use saute_files::regular_file::{self, Unread};

use crate::error::CliError;

/// Larger files are not read [MiB] (chosen: the largest shipped file has 4 kB).
const LARGEST_MIB: u64 = 4;

/// Reads a file of at most so many MiB, with its ending and its content as messages name it.
pub fn bytes(path: &Path, largest_mib: u64, ending: &str, content: &str) -> Result<Vec<u8>, CliError> {
    regular_file::read(path, largest_mib).map_err(|unread| {
        let remedy = match unread {
            Unread::Folder => format!("name a {ending} file in it"),
            Unread::NoFile | Unread::NoText => format!("name a {ending} file"),
            Unread::Large(_) => format!("name {content}"),
            Unread::Io(_) => "check the path and the file's permissions".to_owned(),
        };
        CliError::place(path.display(), unread.to_string(), remedy)
    })
}

/// Reads a UTF-8 file.
pub fn read(path: &Path) -> Result<String, CliError> {
    let bytes = bytes(path, LARGEST_MIB, ".toml", "a TOML file of the documented format")?;
    String::from_utf8(bytes).map_err(|e| not_text(path, &e))
}

fn not_text(path: &Path, error: &std::string::FromUtf8Error) -> CliError {
    let good = error.utf8_error().valid_up_to();
    let line = 1 + error.as_bytes()[..good].iter().filter(|&&b| b == b'\n').count();
    CliError::place(format!("{}:{line}", path.display()), "is not UTF-8 text", "save the file as UTF-8")
}

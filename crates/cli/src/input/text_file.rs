//! Text files.

use std::fs::File;
use std::io::Read;
use std::path::Path;

use crate::error::CliError;

/// Larger files are not read [MiB] (chosen: the largest shipped file has 4 kB).
const LARGEST_MIB: u64 = 4;

/// Reads a file of at most so many MiB, with its ending and what it holds for messages. It must be a regular one: a pipe or a device
/// could block where it is opened, or have no end.
pub fn bytes(path: &Path, largest_mib: u64, ending: &str, content: &str) -> Result<Vec<u8>, CliError> {
    let refused = |message: String, remedy: String| CliError::place(path.display(), message, remedy);
    if path.is_dir() {
        return Err(refused("is a folder, not a file".into(), format!("name a {ending} file in it")));
    }
    if path.metadata().is_ok_and(|data| !data.is_file()) {
        return Err(refused("is a pipe or a device, not a file".into(), format!("name a {ending} file")));
    }
    let largest = largest_mib << 20;
    let mut bytes = Vec::new();
    File::open(path)
        .and_then(|file| file.take(largest + 1).read_to_end(&mut bytes))
        .map_err(|e| refused(format!("cannot be read: {e}"), "check the path and the file's permissions".into()))?;
    if bytes.len() as u64 > largest {
        return Err(refused(format!("is larger than {largest_mib} MiB"), format!("name {content}")));
    }
    Ok(bytes)
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

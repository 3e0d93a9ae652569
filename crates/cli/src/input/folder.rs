//! The files of a kind in a folder.

use std::io;
use std::path::{Path, PathBuf};

/// Returns the files of a folder whose names fit, in the order of their names.
///
/// # Errors
///
/// If the folder cannot be read.
pub fn files(folder: &Path, fits: impl Fn(&str) -> bool) -> io::Result<Vec<PathBuf>> {
    let mut files = Vec::new();
    for entry in folder.read_dir()? {
        let path = entry?.path();
        let name = path.file_name().and_then(|name| name.to_str());
        if path.is_file() && name.is_some_and(&fits) {
            files.push(path);
        }
    }
    files.sort();
    Ok(files)
}

//! The files that students have handed in: named one by one, by a folder, or by a pattern that the shell has not resolved.

use std::path::{Path, PathBuf};

use crate::error::CliError;

/// Ending of a result.
const ENDING: &str = "csv";

/// Returns the files that are meant, each folder's in the order of their names.
///
/// # Errors
///
/// If a folder holds no result, or cannot be read.
pub fn files(named: &[PathBuf]) -> Result<Vec<PathBuf>, CliError> {
    let mut files = Vec::new();
    for path in named {
        match folder(path) {
            Some(folder) => files.extend(results_in(folder, path)?),
            None => files.push(path.clone()),
        }
    }
    Ok(files)
}

/// The folder that a path or a pattern such as `results/*.csv` means; none for a file.
fn folder(path: &Path) -> Option<&Path> {
    if path.is_dir() {
        return Some(path);
    }
    let is_pattern = path.file_name().is_some_and(|name| name == "*.csv" || name == "*");
    let parent = path.parent().map(|parent| if parent.as_os_str().is_empty() { Path::new(".") } else { parent });
    parent.filter(|_| is_pattern && !path.exists())
}

fn results_in(folder: &Path, named: &Path) -> Result<Vec<PathBuf>, CliError> {
    let remedy = "name the folder into which the results were saved";
    let entries = folder.read_dir().map_err(|error| CliError::place(named.display(), error.to_string(), remedy))?;
    let mut files: Vec<PathBuf> = entries
        .flatten()
        .map(|entry| entry.path())
        .filter(|path| path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case(ENDING)))
        .collect();
    files.sort();
    if files.is_empty() {
        return Err(CliError::place(named.display(), "no result is there", remedy));
    }
    Ok(files)
}

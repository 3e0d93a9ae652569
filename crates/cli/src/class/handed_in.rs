//! The files that students have handed in: named one by one, by a folder, or by a pattern that the shell has not resolved.

use std::path::{Path, PathBuf};

use crate::error::CliError;
use crate::input::folder;

/// Ending of a result.
const ENDING: &str = ".csv";

/// Returns the files that are meant, each folder's in the order of their names; or why there are none.
pub fn files(named: &Path) -> Result<Vec<PathBuf>, CliError> {
    match searched(named) {
        Some((folder, [before, after])) => results_in(&folder, named, |name| {
            name.len() >= before.len() + after.len() && name.starts_with(&before) && name.ends_with(&after)
        }),
        None => Ok(vec![named.to_owned()]),
    }
}

/// The folder that a path or a pattern such as `results/first-*.csv` means, and how names in it begin and end; none for a file.
fn searched(named: &Path) -> Option<(PathBuf, [String; 2])> {
    if named.is_dir() {
        return Some((named.to_owned(), [String::new(), String::new()]));
    }
    let (before, after) = named.file_name()?.to_str()?.split_once('*').filter(|_| !named.exists())?;
    let parent = named.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or(Path::new("."));
    Some((parent.to_owned(), [before.to_owned(), after.to_owned()]))
}

fn results_in(folder: &Path, named: &Path, fits: impl Fn(&str) -> bool) -> Result<Vec<PathBuf>, CliError> {
    let none = |why: String| CliError::place(named.display(), why, "name the folder into which the results were saved");
    let files = folder::files(folder, |name| name.to_lowercase().ends_with(ENDING) && fits(name));
    match files.map_err(|error| none(error.to_string()))? {
        files if files.is_empty() => Err(none("no result is there".to_owned())),
        files => Ok(files),
    }
}

//! Files of the system: dialogs that open a recipe and save a cook, the recipes opened before, the folder of pictures.

pub(crate) mod dialog_errors;

use crate::plan::PlanFile;
use saute_files::regular_file;
use saute_session::export::Export;
use std::path::{Path, PathBuf};
use std::sync::mpsc::Receiver;

/// The largest file that is read [MiB] (chosen: far above any recipe, and an hour of a session with the pan in the hand).
const LARGEST_MIB: u64 = 16;

/// Numbers that are tried for a new file [-] (chosen: nobody looks through more).
const MOST_NAMES: u32 = 10_000;

/// What a dialog asks for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Asked {
    /// A file to open.
    Open,
    /// A file that is made of the cook.
    Save(Export),
    /// A file that is made of a plan.
    SavePlan(PlanFile),
}

/// What came of a dialog.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Answer {
    /// A file was chosen.
    Chosen(PathBuf),
    /// The person wants none.
    Cancelled,
    /// The system cannot show a dialog.
    NotShown,
}

/// A dialog that is open in a thread of its own; the window goes on.
#[derive(Debug, Default)]
pub(crate) struct Dialog(pub(crate) Option<(Asked, Receiver<Answer>)>);

/// Returns the path of a new file in a folder: the name, with a number where there is such a file.
pub(crate) fn free_path(folder: &Path, name: &str) -> Result<PathBuf, String> {
    let named = folder.join(name);
    let (stem, ending) = (named.file_stem().unwrap_or_default(), named.extension().unwrap_or_default());
    let (stem, ending) = (stem.to_string_lossy(), ending.to_string_lossy());
    let numbered = (2..MOST_NAMES).map(|n| folder.join(format!("{stem}-{n}.{ending}")));
    first_free(folder, std::iter::once(named.clone()).chain(numbered))
}

/// The first path at which there is no file.
fn first_free(folder: &Path, mut paths: impl Iterator<Item = PathBuf>) -> Result<PathBuf, String> {
    paths.find(|path| !path.exists()).ok_or_else(|| format!("{} holds too many files of that name", folder.display()))
}

pub(crate) fn read(path: &Path) -> Result<Vec<u8>, String> {
    regular_file::read(path, LARGEST_MIB).map_err(|unread| unread.to_string())
}

/// Writes a new picture into a folder, as `saute-N` with an ending; returns its path.
pub(crate) fn write_picture(folder: &Path, ending: &str, bytes: &[u8]) -> Result<PathBuf, String> {
    let path = first_free(folder, (1..MOST_NAMES).map(|n| folder.join(format!("saute-{n}.{ending}"))))?;
    std::fs::write(&path, bytes).map_err(|e| format!("{}: {e}", path.display()))?;
    Ok(path)
}

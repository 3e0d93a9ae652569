//! Files of the system: dialogs that open a recipe and save a cook, the recipes opened before, the folder of pictures.

pub(crate) mod dialog_errors;

use crate::plan::PlanFile;
use saute_session::export::Export;
use std::path::{Path, PathBuf};
use std::sync::mpsc::Receiver;

/// The largest file that is read [bytes] (chosen: far above any recipe, and an hour of a session with the pan in the hand).
const LARGEST: u64 = 16 << 20;

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
pub(crate) fn free_path(folder: &Path, name: &str) -> PathBuf {
    let named = folder.join(name);
    let numbered = |n: u32| {
        let (stem, ending) = (named.file_stem().unwrap_or_default(), named.extension().unwrap_or_default());
        folder.join(format!("{}-{n}.{}", stem.to_string_lossy(), ending.to_string_lossy()))
    };
    let free = std::iter::once(named.clone()).chain((2..10_000).map(numbered)).find(|path| !path.exists());
    free.unwrap_or(named)
}

pub(crate) fn read(path: &Path) -> Result<Vec<u8>, String> {
    let size = std::fs::metadata(path).map_err(|e| e.to_string())?.len();
    if size > LARGEST {
        return Err(format!("it has {size} bytes; a file has at most {LARGEST}"));
    }
    std::fs::read(path).map_err(|e| e.to_string())
}

/// Writes a new picture into a folder, as `saute-N` with an ending; returns its path.
pub(crate) fn write_picture(folder: &Path, ending: &str, bytes: &[u8]) -> Result<PathBuf, String> {
    let mut paths = (1..10_000).map(|n| folder.join(format!("saute-{n}.{ending}")));
    let path = paths.find(|path| !path.exists());
    let path = path.ok_or_else(|| format!("{} holds too many pictures", folder.display()))?;
    std::fs::write(&path, bytes).map_err(|e| format!("{}: {e}", path.display()))?;
    Ok(path)
}

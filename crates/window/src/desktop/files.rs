//! Files of the system: dialogs that open a recipe and save a cook, the recipes opened before, the folder of pictures.

use std::path::{Path, PathBuf};
use std::sync::mpsc::Receiver;

use saute_controls::plan::PlanFile;
use saute_files::regular_file;
use saute_session::export::Export;

/// The largest file that is read [MiB] (chosen: far above any recipe, and an hour of a session with the pan in the hand).
const LARGEST_MIB: u64 = 16;

/// Numbers that are tried for a new file [-] (chosen: nobody looks through more).
const MOST_NAMES: u32 = 10_000;

/// What a dialog is for.
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
pub(crate) enum DialogAnswer {
    /// A file was chosen.
    Chosen(PathBuf),
    /// The person wants none.
    Cancelled,
    /// The system cannot show a dialog.
    NotShown,
}

/// A dialog that is open in its own thread; the window goes on.
#[derive(Debug, Default)]
pub(crate) struct Dialog(pub(crate) Option<(Asked, Receiver<DialogAnswer>)>);

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

/// The folder of pictures: that of the user's folders, else Pictures in the home folder where there is one, else the
/// working folder.
pub(crate) fn pictures_folder() -> PathBuf {
    let home = std::env::var_os(if cfg!(windows) { "USERPROFILE" } else { "HOME" }).map(PathBuf::from);
    let usual = || home.as_ref().map(|home| home.join("Pictures"));
    let named = home.as_deref().and_then(named_by_user);
    let found = named.into_iter().chain(usual()).find(|folder| folder.is_dir());
    found.or_else(|| std::env::current_dir().ok()).unwrap_or_default()
}

/// The folder that the file of the user's folders names (XDG: user-dirs.dirs).
fn named_by_user(home: &Path) -> Option<PathBuf> {
    let config = std::env::var_os("XDG_CONFIG_HOME").map_or_else(|| home.join(".config"), PathBuf::from);
    let text = regular_file::read_text(&config.join("user-dirs.dirs"), 1).ok()?;
    pictures_in(&text, home)
}

fn pictures_in(user_dirs: &str, home: &Path) -> Option<PathBuf> {
    let line = user_dirs.lines().find_map(|line| line.trim().strip_prefix("XDG_PICTURES_DIR="))?;
    let path = line.trim_matches('"');
    Some(path.strip_prefix("$HOME/").map_or_else(|| PathBuf::from(path), |below| home.join(below)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_users_folder_of_pictures_is_read_as_the_desktop_writes_it() {
        let text = "# comment\nXDG_DESKTOP_DIR=\"$HOME/Desktop\"\nXDG_PICTURES_DIR=\"$HOME/Bilder\"\n";
        assert_eq!(pictures_in(text, Path::new("/home/a")), Some(PathBuf::from("/home/a/Bilder")));
        let text = "XDG_PICTURES_DIR=\"/data/pictures\"\n";
        assert_eq!(pictures_in(text, Path::new("/home/a")), Some(PathBuf::from("/data/pictures")));
        assert_eq!(pictures_in("", Path::new("/home/a")), None);
    }
}

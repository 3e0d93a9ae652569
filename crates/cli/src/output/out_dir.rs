//! The output folder: locked and probed before a long run, filled in one go after it.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use crate::error::CliError;
use crate::output::field_files;
use saute_files::{LockedFile, Sorts, StagedFiles};

/// File that is locked while a program writes to the folder.
const LOCK: &str = ".saute-unfinished-lock";

/// Size of the file that probes the folder [bytes] (chosen: a full disk has no room for it, and it takes no time).
const PROBE: usize = 1 << 16;

/// Pages refer to the other files; sections and fields are numbered by the steps of a cook.
const SORTS: Sorts = Sorts { is_page, is_numbered: |name| is_section_picture(name) || is_field(name) };

/// A folder that this program alone writes to. Folders that were made for it are removed if it stays empty.
#[derive(Debug)]
pub struct OutDir {
    path: PathBuf,
    made: Vec<PathBuf>,
    /// Names of files that were written before the end of the run.
    kept: Vec<String>,
    /// The files, then the lock: dropped in this order. None only while the folder is dropped.
    held: Option<(StagedFiles, LockedFile)>,
}

impl OutDir {
    /// Makes the folder, locks it and probes it by a small file, so that a folder without permission, a full disk and another
    /// program are reported before the run. A disk that fills up later is reported by [`OutDir::fill`].
    pub fn prepare(path: &Path) -> Result<Self, CliError> {
        let made = path.ancestors().filter(|p| !p.as_os_str().is_empty() && !p.exists()).map(Path::to_owned).collect();
        let mut out = Self { path: path.to_owned(), made, kept: Vec::new(), held: None };
        match out.hold() {
            Ok(held) => out.held = Some(held),
            Err(e) => return Err(out.error(&e)),
        }
        Ok(out)
    }

    fn hold(&self) -> io::Result<(StagedFiles, LockedFile)> {
        fs::create_dir_all(&self.path)?;
        let lock = LockedFile::take(&self.path.join(LOCK))?;
        let staged = StagedFiles::begin(&self.path, LOCK, SORTS)?;
        staged.write("probe", &[0; PROBE])?;
        staged.remove("probe")?;
        Ok((staged, lock))
    }

    /// Returns the name of the folder for messages.
    pub fn place(&self) -> String {
        self.path.display().to_string()
    }

    /// Writes a file during the run; it gets its final name with all others.
    pub fn keep(&mut self, name: &str, bytes: &[u8]) -> Result<(), CliError> {
        let written = self.held.as_ref().map_or(Ok(()), |(staged, _)| staged.write(name, bytes));
        self.kept.push(name.to_owned());
        written.map_err(|e| self.error(&e))
    }

    /// Returns the number of files that were written during the run.
    pub fn kept(&self) -> usize {
        self.kept.len()
    }

    /// Writes all files or none: they get their final names, with those that were kept, once all of them are complete.
    pub fn fill(mut self, files: Vec<(String, Vec<u8>)>) -> Result<(), CliError> {
        let names: Vec<&str> = files.iter().map(|(name, _)| name).chain(&self.kept).map(String::as_str).collect();
        let written = self.held.as_ref().map_or(Ok(()), |(staged, _)| {
            files.iter().try_for_each(|(name, bytes)| staged.write(name, bytes))?;
            staged.finish(&names)
        });
        written.map_err(|e| self.error(&e))?;
        self.made.clear();
        Ok(())
    }

    /// Returns what is in the folder if the run ends now, for messages.
    pub fn left(&self) -> String {
        match self.made.is_empty() {
            true => format!("nothing was written: {} is as it was before", self.place()),
            false => format!("nothing was written: {} is removed", self.place()),
        }
    }

    fn error(&self, error: &io::Error) -> CliError {
        let remedy = match error.kind() {
            io::ErrorKind::StorageFull | io::ErrorKind::QuotaExceeded | io::ErrorKind::FileTooLarge => {
                "free some space, or name a folder on another disk with --out"
            }
            io::ErrorKind::ResourceBusy => "wait until it has ended, or name another folder with --out",
            _ => "name a folder with write permission with --out",
        };
        CliError::place(format!("--out {}", self.path.display()), format!("cannot be written: {error}"), remedy)
    }
}

impl Drop for OutDir {
    fn drop(&mut self) {
        drop(self.held.take());
        // Innermost first; folders that are not empty stay.
        self.made.iter().for_each(|path| drop(fs::remove_dir(path)));
    }
}

fn is_page(name: &str) -> bool {
    [".html", ".md"].iter().any(|ending| name.ends_with(ending))
}

/// Returns true for the name of a section picture, as `section_03_put.png`.
fn is_section_picture(name: &str) -> bool {
    let digits = name.strip_prefix("section_").and_then(|rest| rest.split('_').next());
    name.ends_with(".png") && digits.is_some_and(|d| d.len() >= 2 && d.bytes().all(|b| b.is_ascii_digit()))
}

/// Returns true for the name of a file of fields, as `fields_0003_pan.vtu`, or of their times.
fn is_field(name: &str) -> bool {
    let digits = name.strip_prefix("fields_").and_then(|rest| rest.split(['_', '.']).next());
    let is_counted = digits.is_some_and(|d| d.len() >= 4 && d.bytes().all(|b| b.is_ascii_digit()));
    name == field_files::SERIES || (name.ends_with(".vtu") && is_counted)
}

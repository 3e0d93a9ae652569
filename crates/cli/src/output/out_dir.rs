//! The output folder: probed before a long run, filled in one go after it.

use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use crate::error::CliError;

/// Prefix of the names of files that are still being written.
const UNFINISHED: &str = ".saute-unfinished-";

/// Size of the file that probes the folder [bytes] (chosen: a full disk has no room for it, and it takes no time).
const PROBE: usize = 1 << 16;

/// A folder that can be written to. Folders that were made for it are removed if it stays empty.
#[derive(Debug)]
pub struct OutDir {
    path: PathBuf,
    made: Vec<PathBuf>,
}

impl OutDir {
    /// Makes the folder and probes it by a small file, so that a folder without permission and a full disk are reported before
    /// the run. A disk that fills up later is reported by [`OutDir::fill`].
    pub fn prepare(path: &Path) -> Result<Self, CliError> {
        let made = path.ancestors().filter(|p| !p.as_os_str().is_empty() && !p.exists()).map(Path::to_owned).collect();
        let out = Self { path: path.to_owned(), made };
        out.probe().map_err(|e| out.error("cannot be written", &e))?;
        Ok(out)
    }

    fn probe(&self) -> io::Result<()> {
        fs::create_dir_all(&self.path)?;
        let probe = self.unfinished("probe");
        let written = write_whole(&probe, &[0; PROBE]);
        // The file is removed in any case; the first error is the one to report.
        let removed = fs::remove_file(&probe);
        written.and(removed)
    }

    /// Returns the name of the folder for messages.
    pub fn place(&self) -> String {
        self.path.display().to_string()
    }

    /// Writes all files or none: they get their final names once all of them are complete.
    pub fn fill(mut self, files: Vec<(String, Vec<u8>)>) -> Result<(), CliError> {
        let written = self.write_all(&files).and_then(|()| self.clear_sections()).and_then(|()| self.name_all(&files));
        if let Err(e) = written {
            files.iter().for_each(|(name, _)| drop(fs::remove_file(self.unfinished(name))));
            return Err(self.error("cannot be written", &e));
        }
        self.made.clear();
        Ok(())
    }

    fn write_all(&self, files: &[(String, Vec<u8>)]) -> io::Result<()> {
        for (name, bytes) in files {
            write_whole(&self.unfinished(name), bytes)?;
        }
        Ok(())
    }

    fn name_all(&self, files: &[(String, Vec<u8>)]) -> io::Result<()> {
        files.iter().try_for_each(|(name, _)| fs::rename(self.unfinished(name), self.path.join(name)))
    }

    /// Removes the section pictures of an earlier cook, which may have had more steps.
    fn clear_sections(&self) -> io::Result<()> {
        for entry in fs::read_dir(&self.path)? {
            let entry = entry?;
            if entry.file_name().to_str().is_some_and(is_section_picture) {
                fs::remove_file(entry.path())?;
            }
        }
        Ok(())
    }

    fn unfinished(&self, name: &str) -> PathBuf {
        self.path.join(format!("{UNFINISHED}{name}"))
    }

    fn error(&self, what: &str, error: &io::Error) -> CliError {
        let remedy = match error.kind() {
            io::ErrorKind::StorageFull | io::ErrorKind::QuotaExceeded | io::ErrorKind::FileTooLarge => {
                "free some space, or name a folder on another disk with --out"
            }
            _ => "name a folder with write permission with --out",
        };
        CliError::place(format!("--out {}", self.path.display()), format!("{what}: {error}"), remedy)
    }
}

impl Drop for OutDir {
    fn drop(&mut self) {
        // Innermost first; folders that are not empty stay.
        self.made.iter().for_each(|path| drop(fs::remove_dir(path)));
    }
}

/// Writes a file and waits until it is on the disk.
fn write_whole(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let mut file = File::create(path)?;
    file.write_all(bytes)?;
    file.sync_all()
}

/// Returns true for the name of a section picture, as `section_03_put.png`.
fn is_section_picture(name: &str) -> bool {
    let digits = name.strip_prefix("section_").and_then(|rest| rest.split('_').next());
    name.ends_with(".png") && digits.is_some_and(|d| d.len() >= 2 && d.bytes().all(|b| b.is_ascii_digit()))
}

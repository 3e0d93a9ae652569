//! The folder that takes a cook's files: tried out before the cook, filled in one go after it.

use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use crate::error::CliError;

/// Beginning of the names of files that are still being written.
const UNFINISHED: &str = ".saute-unfinished-";

/// Largest file that tries out the disk [bytes] (chosen: written in a blink; a cook with more pictures is rare).
const LARGEST_TRIAL: u64 = 64 << 20;

/// A folder that can be written to. What was made for nothing is removed again.
#[derive(Debug)]
pub struct OutDir {
    path: PathBuf,
    made: Vec<PathBuf>,
}

impl OutDir {
    /// Makes the folder and writes as many bytes as the cook may need, then takes them away again.
    pub fn prepare(path: &Path, needed: u64) -> Result<Self, CliError> {
        let made = path.ancestors().filter(|p| !p.as_os_str().is_empty() && !p.exists()).map(Path::to_owned).collect();
        let out = Self { path: path.to_owned(), made };
        out.try_out(needed.min(LARGEST_TRIAL)).map_err(|e| out.error("cannot be written to", &e))?;
        Ok(out)
    }

    fn try_out(&self, needed: u64) -> io::Result<()> {
        fs::create_dir_all(&self.path)?;
        let trial = self.unfinished("trial");
        let outcome = write_trial(&trial, needed);
        // Whatever the outcome: nothing stays behind, and the first error is the one to tell.
        let removed = fs::remove_file(&trial);
        outcome.and(removed)
    }

    /// The folder's name for messages.
    pub fn place(&self) -> String {
        self.path.display().to_string()
    }

    /// Writes all files, or none: they get their names when all of them are complete.
    pub fn fill(mut self, files: Vec<(String, Vec<u8>)>) -> Result<(), CliError> {
        let written = self.write_all(&files).and_then(|()| self.clear_sections()).and_then(|()| self.name_all(&files));
        if let Err(e) = written {
            files.iter().for_each(|(name, _)| drop(fs::remove_file(self.unfinished(name))));
            return Err(self.error("could not be filled", &e));
        }
        self.made.clear();
        Ok(())
    }

    fn write_all(&self, files: &[(String, Vec<u8>)]) -> io::Result<()> {
        for (name, bytes) in files {
            let mut file = File::create(self.unfinished(name))?;
            file.write_all(bytes)?;
            file.sync_all()?;
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
            _ => "name a folder that you may write to with --out",
        };
        CliError::place(format!("--out {}", self.path.display()), format!("{what}: {error}"), remedy)
    }
}

impl Drop for OutDir {
    fn drop(&mut self) {
        // Innermost first; a folder that is not empty refuses, as it should.
        self.made.iter().for_each(|path| drop(fs::remove_dir(path)));
    }
}

fn write_trial(path: &Path, needed: u64) -> io::Result<()> {
    let block = [0x5a; 1 << 16];
    let mut file = File::create(path)?;
    for _ in 0..needed.div_ceil(block.len() as u64) {
        file.write_all(&block)?;
    }
    file.sync_all()
}

/// Whether a file bears the name of a section picture: `section_03_put.png`.
fn is_section_picture(name: &str) -> bool {
    let digits = name.strip_prefix("section_").and_then(|rest| rest.split('_').next());
    name.ends_with(".png") && digits.is_some_and(|d| d.len() >= 2 && d.bytes().all(|b| b.is_ascii_digit()))
}

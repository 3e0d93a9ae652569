//! One file that is written whole or not at all, its place tried out beforehand.

use std::fs::{self, File};
use std::io::Write;
use std::path::{Path, PathBuf};

use crate::error::CliError;

/// A place for a file that can be written to; what was made for nothing is removed again.
#[derive(Debug)]
pub struct OutFile {
    path: PathBuf,
    unfinished: PathBuf,
}

impl OutFile {
    /// Tries the place out.
    pub fn prepare(path: &Path) -> Result<Self, CliError> {
        let place = || format!("--out {}", path.display());
        // A link is followed, so that it stays one; a device or a folder is no place for a picture.
        let path = &path.canonicalize().unwrap_or_else(|_| path.to_owned());
        if path.exists() && !path.is_file() {
            return Err(CliError::place(place(), "is there and is not a file", "write --out FILE.png"));
        }
        let Some(name) = path.file_name() else {
            return Err(CliError::place(place(), "is not a file name", "write --out FILE.png"));
        };
        let unfinished = path.with_file_name(format!(".saute-unfinished-{}", name.display()));
        let out = Self { path: path.to_owned(), unfinished };
        File::create(&out.unfinished).map_err(|e| out.error(&e))?;
        Ok(out)
    }

    /// Writes the file and gives it its name.
    pub fn fill(self, bytes: &[u8]) -> Result<(), CliError> {
        let write = || {
            let mut file = File::create(&self.unfinished)?;
            file.write_all(bytes)?;
            file.sync_all()?;
            fs::rename(&self.unfinished, &self.path)
        };
        write().map_err(|e| self.error(&e))
    }

    fn error(&self, error: &std::io::Error) -> CliError {
        let remedy = "name a file in a folder that you may write to, with free space";
        CliError::place(format!("--out {}", self.path.display()), format!("cannot be written: {error}"), remedy)
    }
}

impl Drop for OutFile {
    fn drop(&mut self) {
        // After a rename there is nothing left to remove.
        let _ = fs::remove_file(&self.unfinished);
    }
}

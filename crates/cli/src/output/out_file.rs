//! One output file: written completely or not at all, its place probed before a long run.

use std::fs::{self, File};
use std::io::Write;
use std::path::{Path, PathBuf};

use crate::error::CliError;

/// A place for a file that can be written to. The unfinished file is removed on drop.
#[derive(Debug)]
pub struct OutFile {
    path: PathBuf,
    unfinished: PathBuf,
}

impl OutFile {
    /// Probes the place with an empty file.
    pub fn prepare(path: &Path) -> Result<Self, CliError> {
        let place = || format!("--out {}", path.display());
        // A link is followed, so that the file behind it is replaced and not the link.
        let path = &path.canonicalize().unwrap_or_else(|_| path.to_owned());
        if path.exists() && !path.is_file() {
            return Err(CliError::place(place(), "exists and is not a file", "write --out FILE.png"));
        }
        let Some(name) = path.file_name() else {
            return Err(CliError::place(place(), "is not a file name", "write --out FILE.png"));
        };
        let unfinished = path.with_file_name(format!(".saute-unfinished-{}", name.display()));
        let out = Self { path: path.to_owned(), unfinished };
        File::create(&out.unfinished).map_err(|e| out.error(&e))?;
        Ok(out)
    }

    /// Writes the file and gives it its final name.
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
        let remedy = "name a file in a folder with write permission and free space";
        CliError::place(format!("--out {}", self.path.display()), format!("cannot be written: {error}"), remedy)
    }
}

impl Drop for OutFile {
    fn drop(&mut self) {
        // After a rename the unfinished file no longer exists.
        let _ = fs::remove_file(&self.unfinished);
    }
}

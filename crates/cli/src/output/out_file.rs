//! One output file: written completely or not at all, its place locked and probed before a long run.

use std::fmt;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use crate::error::CliError;
use saute_files::LockedFile;

/// A place that an option names.
#[derive(Debug)]
pub struct OutPlace {
    option: &'static str,
    path: PathBuf,
}

impl OutPlace {
    /// Locks a place for this program alone, with an example of the option's value for messages. What a dead process has left is
    /// used again.
    pub fn lock(option: &'static str, path: &Path, example: &str) -> Result<(Self, LockedFile), CliError> {
        let wrong = |message: &str| {
            CliError::place(format!("{option} {}", path.display()), message, format!("write {option} {example}"))
        };
        // A link is followed, so that the file behind it is replaced and not the link.
        let place = Self { option, path: path.canonicalize().unwrap_or_else(|_| path.to_owned()) };
        if place.path.exists() && !place.path.is_file() {
            return Err(wrong("exists and is not a file"));
        }
        let Some(name) = place.path.file_name() else {
            return Err(wrong("is not a file name"));
        };
        let unfinished = place.path.with_file_name(format!(".saute-unfinished-{}", name.display()));
        let lock = LockedFile::take(&unfinished).map_err(|e| place.error(&e))?;
        Ok((place, lock))
    }

    /// The file.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Returns why it cannot be written.
    pub fn error(&self, error: &io::Error) -> CliError {
        let remedy = match error.kind() {
            io::ErrorKind::ResourceBusy => "wait until it has ended, or name another file",
            _ => "name a file in a folder with write permission and free space",
        };
        CliError::place(self, format!("cannot be written: {error}"), remedy)
    }
}

impl fmt::Display for OutPlace {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{} {}", self.option, self.path.display())
    }
}

/// A place for a file that this program alone writes to. The unfinished file is removed on drop.
#[derive(Debug)]
pub struct OutFile {
    place: OutPlace,
    unfinished: LockedFile,
}

impl OutFile {
    /// Probes and locks the place of a picture with an empty file.
    pub fn prepare(path: &Path) -> Result<Self, CliError> {
        Self::prepare_as("--out", path, "FILE.png")
    }

    /// As [`Self::prepare`], for another option, with an example of its value.
    pub fn prepare_as(option: &'static str, path: &Path, example: &str) -> Result<Self, CliError> {
        let (place, unfinished) = OutPlace::lock(option, path, example)?;
        Ok(Self { place, unfinished })
    }

    /// Returns the option with its file, for messages.
    pub fn place(&self) -> &OutPlace {
        &self.place
    }

    /// Writes the file and gives it its final name.
    pub fn fill(self, bytes: &[u8]) -> Result<(), CliError> {
        let Self { place, mut unfinished } = self;
        let write = || {
            let file = unfinished.file();
            file.set_len(0)?;
            file.write_all(bytes)?;
            file.sync_all()?;
            unfinished.rename(&place.path)
        };
        write().map_err(|e| place.error(&e))
    }
}

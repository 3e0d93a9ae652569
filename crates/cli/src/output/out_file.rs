//! One output file: written completely or not at all, its place locked and probed before a long run.

use std::io::{self, Write};
use std::path::{Path, PathBuf};

use crate::error::CliError;
use crate::output::file_lock::FileLock;

/// A place for a file that this program alone writes to. The unfinished file is removed on drop.
#[derive(Debug)]
pub struct OutFile {
    /// The option that names it.
    option: &'static str,
    path: PathBuf,
    unfinished: FileLock,
}

impl OutFile {
    /// Probes and locks the place of a picture with an empty file. One that a dead process has left is used again.
    pub fn prepare(path: &Path) -> Result<Self, CliError> {
        Self::prepare_as("--out", path, "FILE.png")
    }

    /// As [`Self::prepare`], for another option, with an example of its value.
    pub fn prepare_as(option: &'static str, path: &Path, example: &str) -> Result<Self, CliError> {
        let wrong = |message: &str| {
            CliError::place(format!("{option} {}", path.display()), message, format!("write {option} {example}"))
        };
        // A link is followed, so that the file behind it is replaced and not the link.
        let path = &path.canonicalize().unwrap_or_else(|_| path.to_owned());
        if path.exists() && !path.is_file() {
            return Err(wrong("exists and is not a file"));
        }
        let Some(name) = path.file_name() else {
            return Err(wrong("is not a file name"));
        };
        let unfinished = path.with_file_name(format!(".saute-unfinished-{}", name.display()));
        let unfinished = FileLock::take(&unfinished).map_err(|e| error(option, path, &e))?;
        Ok(Self { option, path: path.to_owned(), unfinished })
    }

    /// Returns the option with its file, for messages.
    pub fn place(&self) -> String {
        format!("{} {}", self.option, self.path.display())
    }

    /// Writes the file and gives it its final name.
    pub fn fill(self, bytes: &[u8]) -> Result<(), CliError> {
        let Self { option, path, mut unfinished } = self;
        let write = || {
            let file = unfinished.file();
            file.set_len(0)?;
            file.write_all(bytes)?;
            file.sync_all()?;
            unfinished.rename(&path)
        };
        write().map_err(|e| error(option, &path, &e))
    }
}

fn error(option: &str, path: &Path, error: &io::Error) -> CliError {
    let remedy = match error.kind() {
        io::ErrorKind::ResourceBusy => "wait until it has ended, or name another file",
        _ => "name a file in a folder with write permission and free space",
    };
    CliError::place(format!("{option} {}", path.display()), format!("cannot be written: {error}"), remedy)
}

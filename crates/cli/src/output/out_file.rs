//! One output file: written completely or not at all, its place locked and probed before a long run.

use std::io::{self, Write};
use std::path::{Path, PathBuf};

use crate::error::CliError;
use crate::output::file_lock::FileLock;

/// A place for a file that this program alone writes to. The unfinished file is removed on drop.
#[derive(Debug)]
pub struct OutFile {
    path: PathBuf,
    unfinished: FileLock,
}

impl OutFile {
    /// Probes and locks the place with an empty file. One that a dead process has left is used again.
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
        let unfinished = FileLock::take(&unfinished).map_err(|e| error(path, &e))?;
        Ok(Self { path: path.to_owned(), unfinished })
    }

    /// Writes the file and gives it its final name.
    pub fn fill(self, bytes: &[u8]) -> Result<(), CliError> {
        let Self { path, mut unfinished } = self;
        let write = || {
            let file = unfinished.file();
            file.set_len(0)?;
            file.write_all(bytes)?;
            file.sync_all()?;
            unfinished.rename(&path)
        };
        write().map_err(|e| error(&path, &e))
    }
}

fn error(path: &Path, error: &io::Error) -> CliError {
    let remedy = match error.kind() {
        io::ErrorKind::ResourceBusy => "wait until it has ended, or name another file",
        _ => "name a file in a folder with write permission and free space",
    };
    CliError::place(format!("--out {}", path.display()), format!("cannot be written: {error}"), remedy)
}

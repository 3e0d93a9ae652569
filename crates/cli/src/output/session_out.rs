//! `--record FILE.saute`: the session of a cook, written while it cooks.

use std::io;
use std::path::{Path, PathBuf};

use saute_kitchen::{Kitchen, Library};
use saute_recipe::{Recipe, Recording};
use saute_window::session_file::SessionFile;

use crate::error::CliError;
use crate::output::file_lock::FileLock;

/// A place for a session that this program alone writes to.
#[derive(Debug)]
pub struct SessionOut {
    path: PathBuf,
    recording: Recording,
    file: SessionFile,
    _lock: FileLock,
}

impl SessionOut {
    /// Locks the place, and begins the session of a recipe in it. A file that is there is replaced.
    pub fn begin(path: &Path, recipe: &Recipe, library: &Library, kitchen: &Kitchen) -> Result<Self, CliError> {
        let place = || format!("--record {}", path.display());
        let wrong = |message: &str| CliError::place(place(), message, "write --record FILE.saute");
        if path.extension().is_none_or(|ending| ending != saute_recipe::session::session_file::ENDING) {
            return Err(wrong("has the wrong ending"));
        }
        // A link is followed, so that the file behind it is replaced and not the link.
        let path = path.canonicalize().unwrap_or_else(|_| path.to_owned());
        let Some(name) = path.file_name().filter(|_| !path.exists() || path.is_file()) else {
            return Err(wrong("exists and is not a file"));
        };
        let lock = path.with_file_name(format!(".saute-unfinished-{}", name.display()));
        let lock = FileLock::take(&lock).map_err(|e| error(&path, &e))?;
        let mut recording = Recording::begin(recipe, true, library);
        recording.observe(kitchen);
        let file = SessionFile::create(&path, &mut recording).map_err(|e| error(&path, &e))?;
        Ok(Self { path, recording, file, _lock: lock })
    }

    /// Notes that the steps that are due were carried out.
    pub fn on_steps(&mut self, kitchen: &mut Kitchen) {
        self.recording.on_steps(kitchen);
    }

    /// Notes a tick, and writes now and then.
    pub fn on_tick(&mut self, kitchen: &Kitchen) -> Result<(), CliError> {
        self.recording.observe(kitchen);
        self.file.follow(&mut self.recording).map_err(|e| error(&self.path, &e))
    }

    /// Writes the rest.
    pub fn finish(mut self) -> Result<(), CliError> {
        self.file.bring_up_to_date(&mut self.recording).map_err(|e| error(&self.path, &e))
    }
}

fn error(path: &Path, error: &io::Error) -> CliError {
    let remedy = match error.kind() {
        io::ErrorKind::ResourceBusy => "wait until it has ended, or name another file",
        _ => "name a file in a folder with write permission and free space",
    };
    CliError::place(format!("--record {}", path.display()), format!("cannot be written: {error}"), remedy)
}

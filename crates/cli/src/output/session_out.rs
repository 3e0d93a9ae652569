//! `--record FILE.saute`: the session of a cook, written while it cooks.

use std::path::Path;

use saute_controls::kept::session_file::SessionFile;
use saute_kitchen::{Kitchen, Library};
use saute_recipe::{Recipe, Recording};

use crate::error::CliError;
use crate::output::out_file::OutPlace;
use saute_files::LockedFile;

/// Example of the option's value, for messages.
const EXAMPLE: &str = "FILE.saute";

/// A place for a session that this program alone writes to.
#[derive(Debug)]
pub struct SessionOut {
    place: OutPlace,
    recording: Recording,
    file: SessionFile,
    _lock: LockedFile,
}

impl SessionOut {
    /// Locks the place, and begins the session of a recipe in it. A file that is there is replaced.
    pub fn begin(path: &Path, recipe: &Recipe, library: &Library, kitchen: &Kitchen) -> Result<Self, CliError> {
        if path.extension().is_none_or(|ending| ending != saute_recipe::session::session_file::ENDING) {
            let place = format!("--record {}", path.display());
            return Err(CliError::place(place, "has the wrong ending", format!("write --record {EXAMPLE}")));
        }
        let (place, lock) = OutPlace::lock("--record", path, EXAMPLE)?;
        let mut recording = Recording::begin(recipe, true, library);
        recording.observe(kitchen);
        let file = SessionFile::create(place.path(), &mut recording).map_err(|e| place.error(&e))?;
        Ok(Self { place, recording, file, _lock: lock })
    }

    /// Notes that the steps that are due were carried out.
    pub fn on_steps(&mut self, kitchen: &mut Kitchen) {
        self.recording.on_steps(kitchen);
    }

    /// Notes a tick, and writes now and then.
    pub fn on_tick(&mut self, kitchen: &Kitchen) -> Result<(), CliError> {
        self.recording.observe(kitchen);
        self.file.follow(&mut self.recording).map_err(|e| self.place.error(&e))
    }

    /// Writes the rest.
    pub fn finish(mut self) -> Result<(), CliError> {
        self.file.bring_up_to_date(&mut self.recording).map_err(|e| self.place.error(&e))
    }
}

//! The kitchen at the end of the last hour, in a file, from which a run that was cut off goes on.

use std::error::Error;
use std::path::{Path, PathBuf};

use saute_files::write_whole;
use saute_kitchen::{Kitchen, Library};

/// File of the kitchen of the last finished hour.
pub struct KeptKitchen {
    path: PathBuf,
}

impl KeptKitchen {
    /// The file that belongs to a log.
    pub fn of(log: &Path) -> Self {
        Self { path: log.with_extension("kitchen") }
    }

    /// Returns the kept kitchen; `None` if there is none.
    ///
    /// # Errors
    ///
    /// If the file is not one of this program and its data.
    pub fn load(&self, library: &Library) -> Result<Option<Kitchen>, Box<dyn Error>> {
        if !self.path.exists() {
            return Ok(None);
        }
        let read =
            || -> Result<Kitchen, Box<dyn Error>> { Ok(Kitchen::from_bytes(&std::fs::read(&self.path)?, library)?) };
        let remedy = |e| format!("{}: {e}; remove it to begin the day again", self.path.display());
        Ok(Some(read().map_err(remedy)?))
    }

    /// Keeps a kitchen in place of the last one; an interruption leaves one of them whole.
    pub fn keep(&self, kitchen: &Kitchen) -> std::io::Result<()> {
        write_whole(&self.path, &kitchen.to_bytes())
    }

    /// Removes the kitchen of a finished day.
    pub fn clear(&self) -> std::io::Result<()> {
        if self.path.exists() { std::fs::remove_file(&self.path) } else { Ok(()) }
    }
}

//! The file in which the cook that goes on is kept.

use crate::app::SauteApp;
use saute_files::regular_file;
use saute_recipe::session::session_file;
use saute_session::kept::autosave::CookStore;
use std::fs::File;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// A path, and the file once a cook began there.
struct CookFile {
    path: PathBuf,
    file: Option<File>,
}

impl CookFile {
    fn write(file: &mut File, bytes: &[u8]) -> io::Result<()> {
        file.write_all(bytes)?;
        file.sync_data()
    }

    fn create(&self) -> io::Result<File> {
        if let Some(folder) = self.path.parent() {
            std::fs::create_dir_all(folder)?;
        }
        regular_file::check_place(&self.path)?;
        File::create(&self.path)
    }
}

impl CookStore for CookFile {
    fn begin(&mut self, bytes: &[u8]) -> Result<(), String> {
        let mut file = self.create().map_err(|error| error.to_string())?;
        Self::write(&mut file, bytes).map_err(|error| error.to_string())?;
        self.file = Some(file);
        Ok(())
    }

    fn append(&mut self, bytes: &[u8]) -> Result<(), String> {
        let Some(file) = &mut self.file else { return self.begin(bytes) };
        Self::write(file, bytes).map_err(|error| error.to_string())
    }
}

impl SauteApp {
    /// Keeps the cook in a file from now on. What the file contains of an earlier cook is offered first.
    pub fn keep_cook_in(&mut self, path: &Path) {
        let earlier = regular_file::read(path, session_file::LARGEST_MIB).ok();
        self.keep_cook_by(Box::new(CookFile { path: path.to_owned(), file: None }), earlier.as_deref());
    }
}

//! The cook that goes on is kept in a file, so that a window that is closed, or killed, can go on with it.

use std::path::{Path, PathBuf};

use saute_recipe::Recording;

use crate::app::SauteApp;
use crate::session_file::SessionFile;

/// The file of the cook that goes on.
#[derive(Debug, Default)]
pub(crate) struct Autosave {
    path: Option<PathBuf>,
    file: Option<SessionFile>,
    /// Number of the line of time that is in the file.
    line: u64,
    /// The cook that was in the file when the window opened, until it is decided about.
    pub(crate) offered: Option<Recording>,
}

impl SauteApp {
    /// Keeps the cook in a file from now on. What the file holds of an earlier cook is offered first.
    pub fn keep_cook_in(&mut self, path: &Path) {
        let stored = std::fs::read(path).ok().and_then(|bytes| Recording::from_file(&bytes).ok());
        // A cook in which nothing was done is set out again soon enough.
        let offered = stored.map(|opened| opened.recording).filter(|recording| !recording.entries().is_empty());
        self.autosave = Autosave { path: Some(path.to_owned()), offered, ..Autosave::default() };
    }

    /// Goes on with the cook that is offered, or leaves it.
    pub(crate) fn decide_on_offer(&mut self, goes_on: bool) {
        let Some(offered) = self.autosave.offered.take() else { return };
        if !goes_on {
            return;
        }
        if let Err(error) = self.session.resume(offered) {
            self.say_trouble(&error);
        }
    }

    /// Brings the file up to date. An error is said once; then nothing is kept any longer.
    pub(crate) fn keep_cook(&mut self) {
        if self.autosave.offered.is_some() {
            return;
        }
        if let Err(error) = self.autosave.follow(&mut self.session) {
            self.autosave = Autosave::default();
            self.say_trouble(&error);
        }
    }
}

impl Autosave {
    fn follow(&mut self, session: &mut crate::session::Session) -> std::io::Result<()> {
        let Some(path) = &self.path else { return Ok(()) };
        let Some((line, recording)) = session.unsaved() else { return Ok(()) };
        match &mut self.file {
            Some(file) if self.line == line => file.follow(recording),
            _ => {
                if let Some(folder) = path.parent() {
                    std::fs::create_dir_all(folder)?;
                }
                // Another file may hold a part of it.
                *recording = recording.fork(recording.moment());
                (self.file, self.line) = (Some(SessionFile::create(path, recording)?), line);
                Ok(())
            }
        }
    }
}

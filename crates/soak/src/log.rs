//! The log of finished hours.

use std::fs::{File, OpenOptions};
use std::io::{self, Write};
use std::path::Path;

/// File to which a line is added for every hour, if there is one.
pub struct Log(Option<File>);

impl Log {
    /// Opens a log, or begins one; without a path nothing is kept.
    pub fn open(path: Option<&Path>) -> io::Result<Self> {
        path.map(|path| OpenOptions::new().create(true).append(true).open(path)).transpose().map(Self)
    }

    /// Adds the line of an hour.
    pub fn note(&mut self, words: &str) -> io::Result<()> {
        self.0.as_mut().map_or(Ok(()), |file| writeln!(file, "{words}"))
    }
}

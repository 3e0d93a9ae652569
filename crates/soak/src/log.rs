//! The log of finished hours. A kitchen cannot be stored yet, so a run that was cut off repeats its finished hours, and
//! each of them must come out as the log has it.

use std::fs::{File, OpenOptions};
use std::io::{self, Write};
use std::path::Path;

/// Finished hours of this and of earlier runs.
pub struct Log {
    file: Option<File>,
    known: Vec<u64>,
}

impl Log {
    /// Opens a log, or begins one; without a path nothing is kept.
    pub fn open(path: Option<&Path>) -> io::Result<Self> {
        let Some(path) = path else { return Ok(Self { file: None, known: Vec::new() }) };
        let text = if path.exists() { std::fs::read_to_string(path)? } else { String::new() };
        let known = text.lines().map_while(fingerprint).collect();
        Ok(Self { file: Some(OpenOptions::new().create(true).append(true).open(path)?), known })
    }

    /// Returns the number of hours that an earlier run finished.
    pub fn hours(&self) -> usize {
        self.known.len()
    }

    /// Notes a finished hour, counted from 1; returns false if an earlier run had another result.
    pub fn note(&mut self, hour: usize, fingerprint: u64, words: &str) -> io::Result<bool> {
        if let Some(known) = self.known.get(hour - 1) {
            return Ok(*known == fingerprint);
        }
        match &mut self.file {
            Some(file) => writeln!(file, "{fingerprint:016x} {words}").map(|()| true),
            None => Ok(true),
        }
    }
}

/// Returns the fingerprint at the beginning of a whole line.
fn fingerprint(line: &str) -> Option<u64> {
    u64::from_str_radix(line.split_once(' ')?.0, 16).ok()
}

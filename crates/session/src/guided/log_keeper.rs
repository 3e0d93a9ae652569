//! Where the rows of a study go.

use saute_study::LogRow;

/// Where the rows of a study go: a file, a browser's storage, or nowhere.
pub trait LogKeeper {
    /// Appends rows; they are kept whole or not at all.
    ///
    /// # Errors
    ///
    /// Why they are not kept.
    fn append(&mut self, rows: &[LogRow]) -> Result<(), String>;

    /// Returns true if it is a file that people find; then nothing is offered as a download.
    fn is_file(&self) -> bool {
        false
    }

    /// Keeps the session of a trial next to the rows, or returns why it cannot; none where no session is kept.
    fn keep_session(&mut self, _name: &str, _bytes: &[u8]) -> Option<Result<(), String>> {
        None
    }
}

/// Rows stay in memory and are offered as a download.
pub struct InMemory;

impl LogKeeper for InMemory {
    fn append(&mut self, _: &[LogRow]) -> Result<(), String> {
        Ok(())
    }
}

//! One thing that is wrong with a data file.

use serde::Serialize;

use crate::echo::shortened;
use crate::library_error::LibraryError;

/// One thing that is wrong with a file.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Finding {
    /// Line, from 1.
    pub line: usize,
    /// The key; empty if the finding concerns no key.
    pub key: String,
    /// What is wrong.
    pub message: String,
    /// What to write instead.
    pub remedy: String,
}

impl Finding {
    /// Returns a finding; long words and texts in it are shortened.
    pub fn new(line: usize, key: &str, message: String, remedy: impl Into<String>) -> Self {
        let remedy: String = remedy.into();
        let [key, message, remedy] = [key, message.as_str(), remedy.as_str()].map(|text| shortened(text).into_owned());
        Self { line, key, message, remedy }
    }

    /// Returns the error of a file that has this finding.
    pub fn in_file(self, file: &str) -> LibraryError {
        let message = format!("{}: {}", self.message, self.remedy);
        LibraryError { file: file.to_owned(), line: self.line, message }
    }
}

impl From<LibraryError> for Finding {
    fn from(error: LibraryError) -> Self {
        Self::new(error.line, "", error.message, "mend this line")
    }
}

//! The text of a data file with its name: finds the line of a key.

use toml::de::{DeTable, DeValue};

use crate::echo::shortened;
use crate::library_error::{LibraryError, line_of};
use crate::number_text::number_text;

/// A data file: its name in messages and its text.
#[derive(Clone, Copy, Debug)]
pub struct DataFile<'a> {
    /// Name in messages, as `pans/mine.toml`.
    pub name: &'a str,
    /// Text.
    pub text: &'a str,
}

impl DataFile<'_> {
    /// Returns an error at a key, given by its path, as `ridges.width_mm` or `change.0.anchor_c`.
    pub fn error(&self, path: &str, message: impl Into<String>) -> LibraryError {
        let message: String = message.into();
        let message = shortened(&message).into_owned();
        LibraryError { file: self.name.to_owned(), line: self.line_at(path), message }
    }

    /// Returns an error if a number is outside a range that depends on other fields.
    pub fn within(&self, path: &str, value: f64, low: f64, high: f64) -> Result<(), LibraryError> {
        if (low..=high).contains(&value) {
            return Ok(());
        }
        let key = path.split('.').rfind(|part| part.parse::<usize>().is_err()).unwrap_or(path);
        let [value, low, high] = [value, low, high].map(number_text);
        Err(self.error(path, format!("{key} = {value} is out of range: use {low} to {high}")))
    }

    /// Returns the line, from 1, of a key by its path: that of the innermost part that the file has.
    ///
    /// ```
    /// use saute_schema::DataFile;
    ///
    /// let text = "name = \"x\"\n\n[a]\nb = [\n  1.0,\n  2.0,\n]\n[[c]]\nd = 1\n[[c]]\nd = 2\n[a.e]\nd = 3\n";
    /// let file = DataFile { name: "f.toml", text };
    /// let lines = [("", 1), ("name", 1), ("none", 1), ("a", 3), ("a.b", 4), ("a.b.1", 6), ("a.x", 3), ("c.1.d", 11), ("a.e.d", 13)];
    /// for (path, line) in lines {
    ///     assert_eq!(file.line_at(path), line, "{path}");
    /// }
    /// let error = file.within("c.1.d", 2.0, 3.0, 4e8).expect_err("too small");
    /// assert_eq!(error.to_string(), "f.toml:11: d = 2 is out of range: use 3 to 4e8");
    /// ```
    pub fn line_at(&self, path: &str) -> usize {
        let (document, _) = DeTable::parse_recoverable(self.text);
        let (mut line, mut inside) = (1, DeValue::Table(document.into_inner()));
        for part in path.split('.').filter(|part| !part.is_empty()) {
            let found = match inside {
                DeValue::Table(entries) => {
                    entries.into_iter().find(|(key, _)| key.get_ref() == part).map(|(key, v)| (key.span().start, v))
                }
                DeValue::Array(items) => {
                    let item = part.parse().ok().and_then(|at: usize| items.into_iter().nth(at));
                    item.map(|v| (v.span().start, v))
                }
                _ => None,
            };
            let Some((start, value)) = found else { return line };
            line = line_of(self.text, start);
            inside = value.into_inner();
        }
        line
    }
}

//! What is wrong with a file of the user's.

use schemars::JsonSchema;
use serde::de::DeserializeOwned;
use toml::Spanned;

use crate::echo::shortened;
use crate::finding::Finding;
use crate::format::FormatSchema;
use crate::library_error::line_of;
use crate::number_text::number_text;
use crate::schema_text::range_remedy;

/// A file that cannot be used: where, what is wrong, and what to write instead.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{file}:{line}: {message}\n  remedy: {remedy}")]
pub struct InputError {
    /// Which file.
    pub file: String,
    /// Line, from 1.
    pub line: usize,
    /// What is wrong, with the key.
    pub message: String,
    /// What to write instead.
    pub remedy: String,
}

/// A file's text with its name: states where something is wrong.
#[derive(Clone, Copy, Debug)]
pub struct InputText<'a> {
    /// Text.
    pub text: &'a str,
    /// Name in messages.
    pub file: &'a str,
}

impl InputText<'_> {
    /// An error at a byte offset.
    pub fn error<T>(&self, at: usize, message: impl Into<String>, remedy: impl Into<String>) -> Result<T, InputError> {
        let line = line_of(self.text, at);
        let (message, remedy): (String, String) = (message.into(), remedy.into());
        let [message, remedy] = [&message, &remedy].map(|text| shortened(text).into_owned());
        Err(InputError { file: self.file.to_owned(), line, message, remedy })
    }

    /// A number in a range that depends on more than its key.
    pub fn ranged(&self, key: &str, value: &Spanned<f64>, low: f64, high: f64) -> Result<f64, InputError> {
        let v = *value.get_ref();
        if (low..=high).contains(&v) {
            return Ok(v);
        }
        let range = range_remedy(low, if high < f64::MAX { high } else { f64::INFINITY }, false);
        self.error(value.span().start, format!("{key} = {} is out of range", number_text(v)), range)
    }

    /// The key to the left of a value, as "key: "; nothing where there is none.
    fn key_at(&self, at: usize) -> String {
        let line = self.text[..at.min(self.text.len())].rsplit('\n').next().unwrap_or_default();
        let key = line.rsplit_once('=').map(|(key, _)| key.rsplit(['{', ',']).next().unwrap_or_default().trim());
        key.filter(|k| !k.is_empty()).map_or_else(String::new, |k| format!("{k}: "))
    }

    /// Reads the text as TOML of a format: what its schema refuses first; `listed` states where its keys are listed.
    pub fn parse<T: DeserializeOwned + JsonSchema + 'static>(&self, listed: &str) -> Result<T, InputError> {
        if let Some(Finding { line, message, remedy, .. }) =
            FormatSchema::kept::<T>().findings(self.text).into_iter().next()
        {
            return Err(InputError { file: self.file.to_owned(), line, message, remedy });
        }
        toml::from_str(self.text).or_else(|e| {
            let at = e.span().map_or(0, |s| s.start);
            self.error(at, format!("{}{}", self.key_at(at), e.message().trim()), listed)
        })
    }
}

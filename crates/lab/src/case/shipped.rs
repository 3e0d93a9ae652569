//! The embedded validation cases.

use std::collections::BTreeMap;

use include_dir::{Dir, include_dir};

static VALIDATION: Dir = include_dir!("$CARGO_MANIFEST_DIR/../../validation");

/// Returns the list of the cases that there are or were: one id a line, and comments that start with #.
pub fn validation_list() -> &'static str {
    VALIDATION.get_file("index.txt").and_then(|file| file.contents_utf8()).unwrap_or_default()
}

/// Returns the text of every shipped validation case by its id (the file's name without `.toml`).
pub fn validation_cases() -> BTreeMap<String, String> {
    VALIDATION
        .files()
        .filter_map(|file| {
            let id = file.path().to_str()?.strip_suffix(".toml")?;
            Some((id.to_owned(), file.contents_utf8()?.to_owned()))
        })
        .collect()
}

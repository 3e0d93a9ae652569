//! The cases of `saute validate`: the shipped ones, or those of a folder.

use std::collections::BTreeMap;
use std::path::Path;

use super::listed_cases::{Differences, LIST};
use crate::error::CliError;
use crate::input::text_file;

/// The changelog that was current when the command was built.
const CHANGELOG: &str = include_str!("../../../../CHANGELOG.md");
/// Name of the changelog.
const CHANGELOG_FILE: &str = "CHANGELOG.md";

/// Cases with the list that they are compared with.
pub struct CaseFolder {
    /// Path in messages.
    pub path: String,
    /// Text of each case by its id, the name of its file.
    pub cases: BTreeMap<String, String>,
    list: Option<String>,
    changelog: String,
}

impl CaseFolder {
    /// Returns the shipped cases.
    pub fn shipped() -> Self {
        Self {
            path: "validation".into(),
            cases: saute_lab::validation_cases(),
            list: Some(saute_lab::validation_list().to_owned()),
            changelog: CHANGELOG.to_owned(),
        }
    }

    /// Reads the cases of a folder. Its list is optional; the changelog is next to the folder.
    pub fn read(folder: &Path) -> Result<Self, CliError> {
        let unreadable = |e: std::io::Error| {
            CliError::place(folder.display(), format!("cannot be read: {e}"), "name a folder with .toml files")
        };
        let mut cases = BTreeMap::new();
        for entry in std::fs::read_dir(folder).map_err(unreadable)? {
            let path = entry.map_err(unreadable)?.path();
            let id = path.file_stem().and_then(|stem| stem.to_str()).map(str::to_owned);
            if let Some(id) = id.filter(|_| path.extension().is_some_and(|e| e == "toml")) {
                cases.insert(id, text_file::read(&path)?);
            }
        }
        let optional = |path: &Path| path.is_file().then(|| text_file::read(path)).transpose();
        let beside = folder.join("..").join(CHANGELOG_FILE);
        Ok(Self {
            path: folder.display().to_string(),
            cases,
            list: optional(&folder.join(LIST))?,
            changelog: optional(&beside)?.unwrap_or_default(),
        })
    }

    /// Returns the differences between the list and the files; none without a list.
    pub fn differences(&self) -> Differences {
        let compare = |list: &String| Differences::of(&self.cases, list, &self.changelog);
        self.list.as_ref().map(compare).unwrap_or_default()
    }
}

//! File formats: the types of the descriptions state them once; their JSON Schema checks every file.
//!
//! A type that derives [`JsonSchema`] states for each key its meaning (doc comment), its range, its default and an example.
//! [`FormatSchema::findings`] compares a file with that schema and reports unknown and missing keys, wrong types, numbers
//! that are not finite or out of range, and lists of a wrong length. Relations between keys are functions
//! ([`Format::relations`]).

use std::any::TypeId;
use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, PoisonError};

use schemars::generate::SchemaSettings;
use schemars::{JsonSchema, Schema};
use serde::de::DeserializeOwned;
use serde_json::Value;
use toml::de::DeTable;

use crate::data_file::DataFile;
use crate::echo::shortened;
use crate::finding::Finding;
use crate::format_page::FormatPage;
use crate::library_error::{LibraryError, line_of};
use crate::schema_walk::SchemaWalk;

/// A data file's format.
pub trait Format: DeserializeOwned + JsonSchema {
    /// Checks the relations between keys, which ranges of single keys cannot state.
    fn relations(&self, file: &DataFile) -> Result<(), LibraryError>;
}

/// The schema of a format, ready to check files with.
#[derive(Clone, Debug)]
pub struct FormatSchema {
    root: Schema,
}

impl FormatSchema {
    /// Returns the schema of a format with all tables inline.
    pub fn of<T: JsonSchema>() -> Self {
        let settings = SchemaSettings::draft2020_12().with(|s| s.inline_subschemas = true);
        Self { root: settings.into_generator().into_root_schema_for::<T>() }
    }

    /// Returns the schema of a format, which is made once in a program.
    pub fn kept<T: JsonSchema + 'static>() -> Arc<Self> {
        static KEPT: Mutex<BTreeMap<TypeId, Arc<FormatSchema>>> = Mutex::new(BTreeMap::new());
        let mut kept = KEPT.lock().unwrap_or_else(PoisonError::into_inner);
        Arc::clone(kept.entry(TypeId::of::<T>()).or_insert_with(|| Arc::new(Self::of::<T>())))
    }

    /// Returns the schema as JSON.
    pub fn json(&self) -> &Value {
        self.root.as_value()
    }

    /// Returns the reference page of the format, as Markdown: a table of keys for every TOML table.
    pub fn page(&self) -> String {
        FormatPage::over(self.json()).markdown()
    }

    /// Returns everything in a text that the schema refuses, in the order of its lines.
    pub fn findings(&self, text: &str) -> Vec<Finding> {
        let (document, errors) = DeTable::parse_recoverable(text);
        let mut findings = if errors.is_empty() {
            SchemaWalk::over(self.json(), text, document.get_ref())
        } else {
            errors.iter().map(|e| syntax(text, e)).collect()
        };
        findings.sort_by_key(|f| f.line);
        findings
    }

    /// Reads a file: the schema's findings first, then the relations between its keys.
    pub fn read<T: Format>(&self, file: &DataFile) -> Result<T, LibraryError> {
        if let Some(finding) = self.findings(file.text).into_iter().next() {
            return Err(finding.in_file(file.name));
        }
        let refused = |line: usize, message: &str| LibraryError {
            file: file.name.to_owned(),
            line,
            message: shortened(message).into_owned(),
        };
        let table: toml::Table = toml::from_str(file.text)
            .map_err(|e| refused(line_of(file.text, e.span().map_or(0, |s| s.start)), e.message()))?;
        // By way of a table, as the code that reads a type from text is thrice as long; places of keys were for the findings.
        let parsed: T = table.try_into().map_err(|e| refused(1, e.message()))?;
        parsed.relations(file)?;
        Ok(parsed)
    }
}

fn syntax(text: &str, error: &toml::de::Error) -> Finding {
    let line = line_of(text, error.span().map_or(0, |s| s.start));
    let message = error.message().trim();
    let remedy = match message.contains("duplicate key") {
        true => "leave one of the lines out",
        false => "write it as TOML: key = value, text in \"quotes\"",
    };
    Finding::new(line, "", message.to_owned(), remedy)
}

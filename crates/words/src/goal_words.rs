//! Goals by name.

use std::collections::BTreeMap;

use crate::language::Language;

/// Label of a goal: its own in a language, else that of the program.
pub fn label<'a>(name: &'a str, names: &'a BTreeMap<String, String>, l: Language) -> &'a str {
    names.get(l.code()).map_or_else(|| l.called("goal", name), String::as_str)
}

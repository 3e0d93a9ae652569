//! Acts in words: what marks and branches are called.

use crate::language::Language;

/// The label of a mark in a language; a power is a number and needs none.
pub fn act_words(label: &str, l: Language) -> String {
    l.find(&format!("mark.{}", label.replace(' ', "_"))).unwrap_or(label).to_owned()
}

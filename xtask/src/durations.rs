//! The budget of the day: `scripts/durations.toml`.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::Path;

use serde::Deserialize;

use crate::error::{TaskError, at};

/// A step whose work is beyond its budget by more than this share is named [-].
pub const MARGIN: f64 = 0.25;

/// Budgets and ceilings.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Budget {
    /// Work of each step [loops]: processor time over the time of the brick's loop in the same run.
    pub loops: BTreeMap<String, f64>,
    /// What may be counted at most.
    pub ceilings: BTreeMap<String, u64>,
}

impl Budget {
    /// Reads the file.
    ///
    /// # Errors
    ///
    /// If it is not there or contains something else.
    pub fn read(file: &Path) -> Result<Self, TaskError> {
        let text = std::fs::read_to_string(file).map_err(at(file))?;
        Self::parse(&text).map_err(|reason| TaskError::Content { path: file.to_owned(), reason })
    }

    fn parse(text: &str) -> Result<Self, String> {
        let remedy = "write a table [loops] with a number for each step, and a table [ceilings] with whole numbers";
        toml::from_str(text).map_err(|error| format!("{error}remedy: {remedy}"))
    }

    /// Returns the step's name if its work is beyond the budget by more than [`MARGIN`].
    pub fn exceeds(&self, step: &str, loops: f64) -> bool {
        self.loops.get(step).is_some_and(|budget| loops > (1.0 + MARGIN) * budget)
    }

    /// Returns what was counted beyond its ceiling, in words.
    pub fn above(&self, counted: &BTreeMap<String, u64>) -> Vec<String> {
        let above = |(name, most): (&String, &u64)| {
            let count = counted.get(name).filter(|count| *count > most)?;
            Some(format!("{name}: {count}, and {most} are allowed"))
        };
        self.ceilings.iter().filter_map(above).collect()
    }

    /// Returns the file's text with new budgets; comments before the first table stay.
    pub fn blessed(&self, old: &str) -> String {
        let head = old.split("\n[").next().unwrap_or_default().trim_end();
        let mut text = format!("{head}\n\n[loops]\n");
        for (step, loops) in &self.loops {
            let _ = writeln!(text, "{step} = {loops:.0}");
        }
        text.push_str("\n[ceilings]\n");
        for (name, most) in &self.ceilings {
            let _ = writeln!(text, "{name} = {most}");
        }
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn budget() -> Budget {
        Budget { loops: [("tests".to_owned(), 1000.0)].into(), ceilings: [("pages_opened".to_owned(), 50)].into() }
    }

    #[test]
    fn a_step_is_named_when_it_is_a_quarter_beyond_its_budget() {
        assert!(!budget().exceeds("tests", 1249.0));
        assert!(budget().exceeds("tests", 1251.0));
        assert!(!budget().exceeds("a new step", 1e9), "it has no budget yet");
    }

    #[test]
    fn what_is_counted_beyond_its_ceiling_is_named_with_both_numbers() {
        let counted = |pages| [("pages_opened".to_owned(), pages)].into();
        assert!(budget().above(&counted(50)).is_empty());
        assert_eq!(budget().above(&counted(51)), ["pages_opened: 51, and 50 are allowed"]);
    }

    #[test]
    fn a_blessed_file_keeps_its_comments_and_is_read_again() {
        let text = budget().blessed("# Budgets.\n# Two lines.\n\n[loops]\nold = 1\n");
        assert!(text.starts_with("# Budgets.\n# Two lines.\n\n[loops]\ntests = 1000\n"), "{text}");
        assert_eq!(Budget::parse(&text), Ok(budget()));
    }

    #[test]
    fn a_misspelt_table_is_refused_with_the_remedy() {
        let error = Budget::parse("[loop]\ntests = 1\n").expect_err("it is refused");
        assert!(error.contains("loop") && error.contains("remedy: write a table [loops]"), "{error}");
    }
}

//! The rows at the head of VALIDATION.md: the results that most readers look for first.

use std::fmt::Write;

use saute_lab::Verdict;
use serde::Deserialize;

use super::CaseRun;
use super::verdict_text::{number, word};
use crate::error::CliError;

const ROWS: &str = include_str!("twenty.toml");

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Rows {
    row: Vec<Row>,
}

/// A question and the row that answers it.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Row {
    asks: String,
    case: String,
    quantity: String,
}

impl Row {
    fn verdict<'a>(&self, runs: &'a [CaseRun]) -> Option<&'a Verdict> {
        let run = runs.iter().find(|run| run.id == self.case)?;
        run.verdicts.iter().find(|verdict| verdict.quantity == self.quantity)
    }
}

/// Returns the section of those rows that have run, in Markdown; an error names a row of the file that a run case does not have.
pub fn section(runs: &[CaseRun]) -> Result<String, CliError> {
    let rows: Rows = toml::from_str(ROWS).map_err(|e| stale(e.to_string()))?;
    let mut text = String::from(
        "\n## The first twenty\n\nWhat most readers ask first, the largest known misses among it.\n\n\
         | question | quantity | expected | tolerance | got | |\n|---|---|---:|---:|---:|---|\n",
    );
    for row in rows.row {
        if runs.iter().all(|run| run.id != row.case) {
            continue;
        }
        let v = row.verdict(runs).ok_or_else(|| stale(format!("{} has no quantity `{}`", row.case, row.quantity)))?;
        let [expected, tolerance, got] = [Some(v.expected), Some(v.tolerance), v.got].map(number);
        let _ = writeln!(
            text,
            "| {} | {}, {} [{}] | {expected} | {tolerance} | {got} | {} |",
            row.asks,
            v.name,
            v.quantity,
            v.unit,
            word(v)
        );
    }
    Ok(text)
}

fn stale(what: String) -> CliError {
    CliError::place(
        "crates/cli/src/validate/twenty.toml",
        what,
        "name a quantity of the case as `saute validate` prints it",
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::validate::case_folder::CaseFolder;

    #[test]
    fn there_are_twenty_and_each_has_its_question_and_row_in_the_table_of_all() {
        let rows: Rows = toml::from_str(ROWS).expect("rows");
        assert_eq!(rows.row.len(), 20);
        let shipped = CaseFolder::shipped().cases;
        let page = include_str!("../../../../VALIDATION.md");
        for Row { asks, case, quantity } in &rows.row {
            assert!(shipped.contains_key(case), "{case}");
            // Once in the table of all values, once at the head.
            assert!(page.matches(&format!("{quantity} [")).count() >= 2, "{case}: {quantity}");
            assert!(page.contains(&format!("| {asks} |")), "{asks}");
        }
    }
}

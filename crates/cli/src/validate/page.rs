//! The verdicts as text and as Markdown pages.

use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

use saute_kitchen::Library;
use saute_lab::Verdict;

use super::groups::{Group, groups, known};
use super::verdict_text::{number, word};
use super::{CaseRun, frying, picture, segments, twenty};
use crate::error::CliError;
use crate::output::out_file::OutFile;

/// File of the table.
const TABLE: &str = "VALIDATION.md";
/// Folder of the pictures.
const PICTURES: &str = "docs/validation";
/// File of the comparison with segments.
const SEGMENTS: &str = "docs/segments.md";

/// The output files, probed before the cases run.
pub struct Pages {
    table: OutFile,
    segments: OutFile,
}

impl Pages {
    /// Probes the places of the files.
    pub fn prepare() -> Result<Self, CliError> {
        fs::create_dir_all(PICTURES).map_err(|e| {
            let remedy = "run it in a folder with write permission, as in the folder of the project";
            CliError::place(PICTURES, format!("cannot be created: {e}"), remedy)
        })?;
        Ok(Self { table: OutFile::prepare(Path::new(TABLE))?, segments: OutFile::prepare(Path::new(SEGMENTS))? })
    }

    /// Draws the pictures and writes all files; the charts of frying only with the library that cooks for them.
    pub fn fill(self, runs: &[CaseRun], frying: Option<&Library>) -> Result<(), CliError> {
        let mut drawn = vec![("errors".to_owned(), picture::errors(runs))];
        drawn.extend(runs.iter().filter_map(|run| Some((run.id.clone(), picture::curves(run)?))));
        if let Some(library) = frying {
            drawn.extend(frying::charts(library, runs)?);
        }
        let (page, pictures) = segments::page(runs);
        drawn.extend(pictures);
        for (name, svg) in &drawn {
            OutFile::prepare(&picture_path(name))?.fill(svg.as_bytes())?;
        }
        self.segments.fill(page.as_bytes())?;
        if frying.is_some() {
            clear_old_pictures(&drawn)?;
        }
        let names: Vec<&str> = drawn.iter().map(|(name, _)| name.as_str()).collect();
        self.table.fill(markdown(runs, &names)?.as_bytes())
    }
}

/// Removes the pictures of cases that no longer exist.
fn clear_old_pictures(drawn: &[(String, String)]) -> Result<(), CliError> {
    let clear = || {
        for entry in fs::read_dir(PICTURES)? {
            let path = entry?.path();
            let kept = path.file_stem().is_none_or(|stem| drawn.iter().any(|(name, _)| stem == name.as_str()));
            if path.extension().is_some_and(|e| e == "svg") && !kept {
                fs::remove_file(&path)?;
            }
        }
        Ok(())
    };
    clear().map_err(|e: std::io::Error| {
        CliError::place(PICTURES, format!("old pictures cannot be removed: {e}"), "remove its .svg files by hand")
    })
}

fn picture_path(name: &str) -> PathBuf {
    Path::new(PICTURES).join(format!("{name}.svg"))
}

/// Returns how many of all values that pass or fail hold, in words.
fn held(runs: &[CaseRun]) -> String {
    let verdicts = || runs.iter().flat_map(|r| &r.verdicts);
    let count = |pass: bool| verdicts().filter(|v| v.pass == Some(pass)).count();
    let misses = known(verdicts().filter(|v| v.misses_as_known()).count());
    format!("{} of {} values hold{misses}", count(true), count(true) + count(false))
}

/// Returns the tables for a terminal: the groups, and in each the cases with the largest errors first.
pub fn text(runs: &[CaseRun]) -> String {
    let mut text = String::new();
    for group in groups(runs) {
        let _ = writeln!(text, "{} ({})", group.title(), group.description());
        let mut ids: Vec<&str> = Vec::new();
        for (run, _) in &group.rows {
            if !ids.contains(&run.id.as_str()) {
                ids.push(&run.id);
                let rows = group.rows.iter().filter(|(other, _)| other.id == run.id);
                case_text(&mut text, rows.map(|(_, v)| *v));
            }
        }
        let _ = writeln!(text, "{}: {}\n", group.title(), group.summary_line());
    }
    let _ = writeln!(text, "{}", held(runs));
    text
}

/// Adds the lines of a case: its name, its source and its values.
fn case_text<'a>(text: &mut String, verdicts: impl Iterator<Item = &'a Verdict>) {
    let mut named = false;
    for v in verdicts {
        if !named {
            let _ = writeln!(text, "  {}\n    {}", v.name, v.source);
            named = true;
        }
        let (got, error) = (number(v.got), number(v.error));
        let _ = writeln!(
            text,
            "    {:<22} expected {:>11.4} ± {:<8.4} got {got:>11} {:<2} error {error:>9}  {}",
            v.quantity,
            v.expected,
            v.tolerance,
            v.unit,
            word(v)
        );
    }
}

fn markdown(runs: &[CaseRun], pictures: &[&str]) -> Result<String, CliError> {
    let groups = groups(runs);
    let mut text = format!(
        "# Validation\n\nWritten by `saute validate --write`. Every case is a file in `validation/`; the expected values come \
         from outside this program. They are about the mean piece of a food; \
         real ones differ, as `docs/sweeps.md` shows. {}. [docs/segments.md](docs/segments.md) shows what the shape functions \
         gain over the segments of earlier work.\n\n",
        held(runs)
    );
    for group in &groups {
        let _ = writeln!(text, "- {}: {}.", group.title(), group.summary_line());
    }
    text.push_str(&twenty::section(runs)?);
    let _ = write!(text, "\n![every error over its tolerance]({PICTURES}/errors.svg)\n");
    for group in &groups {
        table(&mut text, group, pictures);
    }
    known_misses(&mut text, runs);
    text.push_str("\n## Sources\n\n");
    let mut sources: Vec<&str> = runs.iter().flat_map(|r| &r.verdicts).map(|v| v.source.as_str()).collect();
    sources.sort_unstable();
    sources.dedup();
    sources.iter().for_each(|s| text.push_str(&format!("- {s}\n")));
    Ok(text)
}

/// Adds the reasons of all known misses.
fn known_misses(text: &mut String, runs: &[CaseRun]) {
    text.push_str("\n## Known misses\n\n");
    for v in runs.iter().flat_map(|r| &r.verdicts) {
        if let Some(why) = &v.known_miss {
            let (expected, got) = ([v.expected - v.tolerance, v.expected + v.tolerance], number(v.got));
            let [low, high] = expected.map(|e| number(Some(e)));
            let _ = writeln!(
                text,
                "- {}, {}: {low} to {high} {} expected, {got} computed. {why}",
                v.name, v.quantity, v.unit
            );
        }
    }
}

/// Adds the section of a group.
fn table(text: &mut String, group: &Group, pictures: &[&str]) {
    let _ = write!(
        text,
        "\n## {}\n\nExpected values: {}. {}. Largest error over tolerance first.\n\n\
         | case | quantity | expected | tolerance | got | error | error over tolerance | |\n\
         |---|---|---:|---:|---:|---:|---:|---|\n",
        group.title(),
        group.description(),
        group.summary_line()
    );
    for (run, v) in &group.rows {
        text.push_str(&table_row(run, v, pictures.contains(&run.id.as_str())));
    }
}

/// Returns a row of a Markdown table; the name links to the picture of the case if there is one.
fn table_row(run: &CaseRun, v: &Verdict, is_pictured: bool) -> String {
    let name = if is_pictured { format!("[{}]({PICTURES}/{}.svg)", v.name, run.id) } else { v.name.clone() };
    let (got, error) = (number(v.got), number(v.error));
    format!(
        "| {name} | {} [{}] | {:.4} | {:.4} | {got} | {error} | {:.2} | {} |\n",
        v.quantity,
        v.unit,
        v.expected,
        v.tolerance,
        v.error_share(),
        word(v)
    )
}

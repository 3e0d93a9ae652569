//! The verdicts as text and as Markdown pages.

use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

use saute_lab::Verdict;

use super::{CaseRun, picture, segments};
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

    /// Draws the pictures and writes all files.
    pub fn fill(self, runs: &[CaseRun]) -> Result<(), CliError> {
        let mut drawn = vec![("errors".to_owned(), picture::errors(runs))];
        drawn.extend(runs.iter().filter_map(|run| Some((run.id.clone(), picture::curves(run)?))));
        let (page, pictures) = segments::page(runs);
        drawn.extend(pictures);
        for (name, svg) in &drawn {
            OutFile::prepare(&picture_path(name))?.fill(svg.as_bytes())?;
        }
        self.segments.fill(page.as_bytes())?;
        clear_old_pictures(&drawn)?;
        let names: Vec<&str> = drawn.iter().map(|(name, _)| name.as_str()).collect();
        self.table.fill(markdown(runs, &names).as_bytes())
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

fn word(verdict: &Verdict) -> &'static str {
    if verdict.pass { "holds" } else { "FALLS SHORT" }
}

/// Returns a value with four decimals, or `none`.
pub fn number(value: Option<f64>) -> String {
    value.map_or_else(|| "none".into(), |v| format!("{v:.4}"))
}

/// Returns the table for a terminal.
pub fn text(verdicts: &[Verdict]) -> String {
    let mut text = String::new();
    let mut name = "";
    for v in verdicts {
        if v.name != name {
            name = &v.name;
            let _ = writeln!(text, "{name}\n  {}", v.source);
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
    let held = verdicts.iter().filter(|v| v.pass).count();
    let _ = writeln!(text, "{held} of {} values hold", verdicts.len());
    text
}

fn markdown(runs: &[CaseRun], pictures: &[&str]) -> String {
    let verdicts: Vec<&Verdict> = runs.iter().flat_map(|r| &r.verdicts).collect();
    let held = verdicts.iter().filter(|v| v.pass).count();
    let mut text = format!(
        "# Validation\n\nWritten by `saute validate --write`. Every case is a file in `validation/`; the expected values come \
         from outside this program. {held} of {} values hold. [docs/segments.md](docs/segments.md) shows what the shape functions \
         gain over the segments of earlier work.\n\n![every error over its tolerance]({PICTURES}/errors.svg)\n\n\
         | case | quantity | expected | tolerance | got | error | |\n|---|---|---:|---:|---:|---:|---|\n",
        verdicts.len()
    );
    for run in runs {
        let is_pictured = pictures.contains(&run.id.as_str());
        run.verdicts.iter().for_each(|v| text.push_str(&table_row(run, v, is_pictured)));
    }
    text.push_str("\n## Sources\n\n");
    let mut sources: Vec<&str> = verdicts.iter().map(|v| v.source.as_str()).collect();
    sources.sort_unstable();
    sources.dedup();
    sources.iter().for_each(|s| text.push_str(&format!("- {s}\n")));
    text
}

/// Returns a row of the Markdown table; the name links to the picture of the case if there is one.
fn table_row(run: &CaseRun, v: &Verdict, is_pictured: bool) -> String {
    let name = if is_pictured { format!("[{}]({PICTURES}/{}.svg)", v.name, run.id) } else { v.name.clone() };
    let (got, error) = (number(v.got), number(v.error));
    format!(
        "| {name} | {} [{}] | {:.4} | {:.4} | {got} | {error} | {} |\n",
        v.quantity,
        v.unit,
        v.expected,
        v.tolerance,
        word(v)
    )
}

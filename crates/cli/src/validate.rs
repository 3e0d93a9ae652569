//! `saute validate`.

use std::fmt::Write;
use std::path::Path;
use std::process::ExitCode;
use std::time::Instant;

use saute_kitchen::Library;
use saute_kitchen::cook_case::CookCase;
use saute_kitchen::lab::{Case, Verdict, run, verdicts};
use serde::Serialize;

use crate::args::ValidateArgs;
use crate::error::CliError;
use crate::out_file::OutFile;
use crate::shelf::Shelf;
use crate::stdout;

/// Exit code when a case falls short.
const SHORT: u8 = 1;
/// Where the table is written.
const TABLE_FILE: &str = "VALIDATION.md";

/// All verdicts, as `--json` prints them.
#[derive(Serialize)]
struct Verdicts {
    cases: Vec<Verdict>,
}

/// Runs the cases and tells their verdicts.
pub fn validate(args: &ValidateArgs, shelf: &Shelf) -> Result<ExitCode, CliError> {
    let table = args.write.then(|| OutFile::prepare(Path::new(TABLE_FILE))).transpose()?;
    let verdicts = Verdicts { cases: run_cases(args.case.as_deref(), shelf)? };
    if let Some(table) = table {
        table.fill(markdown(&verdicts.cases).as_bytes())?;
    }
    stdout::print(&if args.json {
        format!("{}\n", serde_json::to_string_pretty(&verdicts)?)
    } else {
        text(&verdicts.cases)
    })?;
    let all = verdicts.cases.iter().all(|v| v.pass);
    Ok(if all { ExitCode::SUCCESS } else { ExitCode::from(SHORT) })
}

fn run_cases(only: Option<&str>, shelf: &Shelf) -> Result<Vec<Verdict>, CliError> {
    let cases = Library::validation_cases();
    if let Some(id) = only.filter(|id| !cases.contains_key(*id)) {
        let remedy = format!("use one of: {}", Library::names(&cases));
        return Err(CliError::place(format!("--case {id}"), "there is no such case", remedy));
    }
    let mut all = Vec::new();
    for (id, text) in cases.iter().filter(|(id, _)| only.is_none_or(|o| o == *id)) {
        all.extend(run_case(text, &format!("validation/{id}.toml"), &shelf.library)?);
    }
    Ok(all)
}

fn run_case(text: &str, file: &str, library: &Library) -> Result<Vec<Verdict>, CliError> {
    if CookCase::is_one(text) {
        return Ok(CookCase::parse(text, file, library)?.verdicts(library)?);
    }
    let case = Case::parse(text, file, library)?;
    let start = Instant::now();
    Ok(verdicts(&case, &run(&case, || start.elapsed().as_secs_f64())))
}

fn word(verdict: &Verdict) -> &'static str {
    if verdict.pass { "holds" } else { "FALLS SHORT" }
}

fn number(value: Option<f64>) -> String {
    value.map_or_else(|| "none".into(), |v| format!("{v:.4}"))
}

fn text(verdicts: &[Verdict]) -> String {
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

fn markdown(verdicts: &[Verdict]) -> String {
    let mut text = String::from(
        "# Validation\n\nWritten by `saute validate --write`. Every case is a file in `validation/`; the expected values come \
         from outside this program.\n\n| case | quantity | expected | tolerance | got | error | |\n|---|---|---:|---:|---:|---:|---|\n",
    );
    for v in verdicts {
        let (got, error) = (number(v.got), number(v.error));
        let _ = writeln!(
            text,
            "| {} | {} [{}] | {:.4} | {:.4} | {got} | {error} | {} |",
            v.name,
            v.quantity,
            v.unit,
            v.expected,
            v.tolerance,
            word(v)
        );
    }
    text.push_str("\n## Sources\n\n");
    let mut sources: Vec<&str> = verdicts.iter().map(|v| v.source.as_str()).collect();
    sources.sort_unstable();
    sources.dedup();
    sources.iter().for_each(|s| text.push_str(&format!("- {s}\n")));
    text
}

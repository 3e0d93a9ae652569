//! `saute class`: the results of a class.

mod handed_in;
mod simulate;

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Subcommand;
use saute_study::LogError;
use saute_study::class::{Bar, ClassSummary, ResultRow, ScenarioSummary, from_csv, to_csv};

pub use simulate::SimulateArgs;

use crate::error::CliError;
use crate::exit_code;
use crate::input::data_library::DataLibrary;
use crate::input::text_file;
use crate::output::out_file::OutFile;
use crate::output::{json, stderr, stdout};

/// `saute class`.
#[derive(Debug, Subcommand)]
pub enum ClassCommand {
    /// Merges the results of students, each a CSV file that a lesson has given, into one CSV file, and prints what the class did.
    Collect(CollectArgs),
    /// Lets simulated students take a lesson: rule-based cooks who guess, for trying how results are collected. They prove nothing about
    /// people.
    Simulate(SimulateArgs),
}

/// `saute class collect`.
#[derive(Debug, clap::Args)]
pub struct CollectArgs {
    /// Results of students: files, folders of them, or a pattern such as results/*.csv.
    #[arg(value_name = "FILE.csv", required = true)]
    pub files: Vec<PathBuf>,
    /// File with all results; a result that is there twice is written once.
    #[arg(long, value_name = "CLASS.csv")]
    pub out: Option<PathBuf>,
    /// Prints the summary as JSON.
    #[arg(long)]
    pub json: bool,
}

/// Largest file that is read [MiB] (chosen: a class has a few kilobytes).
const LARGEST_MIB: u64 = 8;

/// What to do about a file or a row that is none of a lesson's.
const REMEDY: &str = "correct the row or leave the file out: results are what a lesson has given, with a code of letters, digits and hyphens";

/// Widest bar [marks] (chosen: a line of a terminal).
const WIDEST: usize = 40;

/// Runs the command; results are collected without the library.
pub fn run(
    command: &ClassCommand,
    library: impl FnOnce() -> Result<DataLibrary, CliError>,
) -> Result<ExitCode, CliError> {
    match command {
        ClassCommand::Simulate(args) => simulate::run(args, &library()?),
        ClassCommand::Collect(args) => collect(args),
    }
}

fn collect(args: &CollectArgs) -> Result<ExitCode, CliError> {
    let (mut rows, mut refused) = (Vec::new(), Vec::new());
    for result in args.files.iter().flat_map(|named| results(named)) {
        match result {
            Ok(read) => rows.extend(read),
            Err(error) => refused.push(error),
        }
    }
    if rows.is_empty() && !refused.is_empty() {
        // Nothing is left to be collected: the first reason stands for all.
        return Err(refused.swap_remove(0));
    }
    for error in &refused {
        stderr::say(format!("left out: {error}"));
    }
    let (merged, summary) = ClassSummary::of(&rows);
    if let Some(path) = &args.out {
        let file = OutFile::prepare_as("--out", path, "CLASS.csv")?;
        file.fill(to_csv(&merged).as_bytes())?;
        stderr::say(format!("wrote {} results to {}", merged.len(), path.display()));
    }
    stdout::print(&if args.json { json::text(&summary)? } else { text(&summary, rows.len() - merged.len()) })?;
    Ok(exit_code::of_goal(refused.is_empty()))
}

/// What is read of each file that a path means.
fn results(named: &Path) -> Vec<Result<Vec<ResultRow>, CliError>> {
    match handed_in::files(named) {
        Ok(files) => files.iter().map(|file| read(file)).collect(),
        Err(error) => vec![Err(error)],
    }
}

fn read(path: &Path) -> Result<Vec<ResultRow>, CliError> {
    let bytes = text_file::bytes(path, LARGEST_MIB, ".csv", "a student's result")?;
    let place = path.display().to_string();
    let rows = from_csv(&place, &String::from_utf8_lossy(&bytes)).map_err(|LogError { file, line, message }| {
        let (message, remedy) = message.rsplit_once("; ").unwrap_or((&message, REMEDY));
        CliError::place(format!("{file}:{line}"), message, remedy)
    })?;
    if rows.is_empty() {
        return Err(CliError::place(place, "has no result in it", "ask the student to hand it in again"));
    }
    Ok(rows)
}

fn text(summary: &ClassSummary, twice: usize) -> String {
    let mut lines = Vec::new();
    for s in &summary.scenarios {
        lines.push(format!(
            "{} ({}): {} of {}, {} without a code",
            s.scenario,
            s.checksum,
            counted(s.results, "result"),
            counted(s.students, "student"),
            s.without_code
        ));
        lines.push(format!(
            "  goal met {} of {}; medians: {}, share on target {:.1} %",
            s.met,
            s.results,
            points(s),
            s.median_target_share_pct
        ));
        for q in &s.questions {
            let compared = |e| format!("{} compared, median error {e:.1}", q.compared);
            let error = q.median_error.map_or_else(|| "not compared".to_owned(), compared);
            lines.push(format!("  question {}: {}, {error}", q.question, counted(q.answers, "answer")));
            if q.early_truths > 0 {
                lines.push(format!(
                    "    {} truths left out: an earlier version noted them before the food had rested, and score and peak with them",
                    q.early_truths
                ));
            }
            lines.extend(histogram(&q.bars));
        }
    }
    if twice > 0 {
        let [were, count] = if twice == 1 { ["was", "counts"] } else { ["were", "count"] };
        lines.push(format!("{} {were} there twice and {count} once", counted(twice, "result")));
    }
    lines.iter().map(|line| format!("{line}\n")).collect()
}

/// The points that students see; those of results from before they were kept are scores, which may be negative.
fn points(s: &ScenarioSummary) -> String {
    s.median_mark.map_or_else(|| format!("score {:.1}", s.median_score), |mark| format!("{mark:.0} of 100 points"))
}

/// A count with its noun.
fn counted(count: usize, noun: &str) -> String {
    format!("{count} {noun}{}", if count == 1 { "" } else { "s" })
}

/// A line for each bar: `#` is an answer, `o` a truth.
fn histogram(bars: &[Bar]) -> Vec<String> {
    let line = |bar: &Bar| {
        let range = if bar.to - bar.from > 1.0 { format!("{} to {}", bar.from, bar.to) } else { bar.from.to_string() };
        let marks = format!("{}{}", "#".repeat(bar.answers.min(WIDEST)), "o".repeat(bar.truths.min(WIDEST)));
        format!("    {range:>9} |{marks:<12} {}, {}", counted(bar.answers, "answer"), counted(bar.truths, "truth"))
    };
    bars.iter().map(line).collect()
}

//! `saute sweep`: a recipe cooked many times with values that vary, on all cores, into a folder of Parquet files.

mod bar;
mod report;

use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::Arc;
use std::time::{Duration, Instant};

use clap::Subcommand;
use saute_sweep::{Base, SpecFile, Sweep};
use saute_sweep_folder::cooking::{cook_all, cores};
use saute_sweep_folder::{FolderError, ROWS, SweepFolder, Tally};
use serde::Serialize;

use crate::error::CliError;
use crate::exit_code;
use crate::input::data_library::DataLibrary;
use crate::input::{recipe_source, text_file};
use crate::output::interruption::Interruption;
use crate::output::{json, stderr, stdout};
use crate::wording::duration;
use bar::Bar;
use report::ReportArgs;

/// `saute sweep`.
#[derive(Debug, clap::Args)]
#[command(args_conflicts_with_subcommands = true, subcommand_negates_reqs = true)]
pub struct SweepArgs {
    /// Tables and plots of a sweep.
    #[command(subcommand)]
    pub command: Option<SweepCommand>,
    /// Specification: recipe, what varies and how (`saute schema sweep`).
    #[arg(value_name = "SPEC.toml", required = true)]
    pub spec: Option<PathBuf>,
    /// Folder of the results: rows/part-*.parquet. A sweep that was broken off or killed goes on where it was.
    #[arg(long, value_name = "DIR", required = true)]
    pub out: Option<PathBuf>,
    /// Cooks at the same time [default: one for each core]. The results do not depend on it.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub jobs: Option<u16>,
    /// Prints how many rows there are as JSON.
    #[arg(long)]
    pub json: bool,
}

/// Tables and plots of a sweep.
#[derive(Debug, Subcommand)]
pub enum SweepCommand {
    /// Says which values matter: Sobol' indices of a design `saltelli`, elementary effects of a design `morris`, as CSV and a page.
    Report(ReportArgs),
}

/// What a run of a sweep prints as JSON.
#[derive(Debug, Serialize)]
struct SweepReport {
    out: PathBuf,
    rows: u64,
    done: u64,
    failed: u64,
    /// Rows that were cooked in this run.
    cooked: u64,
    jobs: usize,
    wall_s: f64,
}

/// Cooks what is missing of a sweep, or makes its report.
pub fn run(args: &SweepArgs, data: &DataLibrary) -> Result<ExitCode, CliError> {
    match (&args.command, &args.spec, &args.out) {
        (Some(SweepCommand::Report(args)), ..) => report::run(args),
        (None, Some(spec), Some(out)) => cook(spec, out, args, data),
        _ => Err(CliError::place("saute sweep", "needs a specification and --out", "see: saute sweep --help")),
    }
}

fn cook(spec: &Path, out: &Path, args: &SweepArgs, data: &DataLibrary) -> Result<ExitCode, CliError> {
    let sweep = Arc::new(load(spec, data)?);
    sweep.doubts().iter().for_each(|doubt| stderr::say(format!("warning: some rows will fail: {doubt}")));
    let folder = SweepFolder::open(out, sweep).map_err(of_folder)?;
    let jobs = args.jobs.map_or_else(cores, usize::from);
    let interruption = Interruption::watch();
    let started = Instant::now();
    let bar = Bar::start(folder.tally());
    let tally = cook_all(folder, jobs, &|tally| bar.show(tally), &|| !interruption.is_asked()).map_err(of_folder)?;
    drop(bar);
    if !tally.is_complete() {
        return Err(CliError::SweepInterrupted { done: tally.done, rows: tally.rows });
    }
    say(tally, out, jobs, started.elapsed(), args.json)?;
    Ok(exit_code::of_goal(tally.failed == 0))
}

fn say(tally: Tally, out: &Path, jobs: usize, wall: Duration, as_json: bool) -> Result<(), CliError> {
    if tally.failed > 0 {
        stderr::say(format!("{} of {} rows could not be cooked: see their column message", tally.failed, tally.rows));
    }
    let (out, wall_s) = (out.join(ROWS), wall.as_secs_f64());
    let Tally { rows, done, failed, fresh } = tally;
    let text = format!("{rows} rows in {}; {fresh} cooked in {}, {jobs} at a time\n", out.display(), duration(wall_s));
    let answer = SweepReport { out, rows, done, failed, cooked: fresh, jobs, wall_s };
    stdout::print(&if as_json { json::text(&answer)? } else { text })
}

/// Reads a specification with its recipe, which is a file in the same folder or one of the library.
fn load(spec: &Path, data: &DataLibrary) -> Result<Sweep, CliError> {
    let (text, place) = (text_file::read(spec)?, spec.display().to_string());
    let recipe = SpecFile::parse(&text, &place)?.recipe;
    let line = 1 + text[..recipe.span().start].matches('\n').count();
    let name = recipe.into_inner();
    let beside = spec.with_file_name(&name);
    let name = if beside.is_file() { beside.display().to_string() } else { name };
    let (recipe, file) = recipe_source::text(&name, data).map_err(|error| match error {
        CliError::Place { place: named, message, remedy } => {
            CliError::Place { place: format!("{place}:{line}: {named}"), message, remedy }
        }
        other => other,
    })?;
    Ok(Sweep::new(&text, &place, Base { recipe, file, own: data.own_files().clone() })?)
}

fn of_folder(error: FolderError) -> CliError {
    CliError::place(format!("--out {}", error.place), error.message, error.remedy)
}

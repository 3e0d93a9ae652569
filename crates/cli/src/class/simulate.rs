//! `saute class simulate`.

use std::path::PathBuf;
use std::process::ExitCode;
use std::sync::Arc;

use saute_study::class::to_csv;
use saute_study::simulated::SimulatedClass;

use crate::commands::open;
use crate::error::CliError;
use crate::input::data_library::DataLibrary;
use crate::output::out_dir::OutDir;
use crate::output::progress::Progress;
use crate::output::{stderr, stdout};
use crate::workers::map_all;

/// `saute class simulate`.
#[derive(Debug, clap::Args)]
pub struct SimulateArgs {
    /// Scenario file, or id of a shipped scenario (`saute list scenarios`).
    #[arg(value_name = "SCENARIO")]
    pub scenario: String,
    /// Number of simulated students.
    #[arg(long, value_name = "N", default_value_t = 5, value_parser = clap::value_parser!(u32).range(1..=99))]
    pub students: u32,
    /// Seed of all draws: the same seed gives the same results.
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub seed: u64,
    /// Folder of the results; created if missing.
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
}

/// Lets simulated students take the lesson, and writes what each hands in.
pub fn run(args: &SimulateArgs, data: &DataLibrary) -> Result<ExitCode, CliError> {
    let scenario = open::scenario(&args.scenario, data)?;
    let out = OutDir::prepare(&args.out)?;
    let progress = Progress::over(args.students.into());
    let class = SimulatedClass { scenario: Arc::clone(&scenario), seed: args.seed };
    let numbers: Vec<u32> = (1..=args.students).collect();
    let rows = map_all(&numbers, |_, number| {
        let row = class.row(*number, &data.library);
        progress.next(format!("student {number} of {}", args.students));
        row
    });
    drop(progress);
    let mut files = Vec::new();
    for row in rows {
        let row = row.map_err(|error| {
            CliError::place(&args.scenario, error.to_string(), "set out one piece of food that can be cooked")
        })?;
        let student = row.student.clone().unwrap_or_default();
        files.push((format!("{}-{student}.csv", scenario.id), to_csv(&[row]).into_bytes()));
    }
    let place = out.place();
    out.fill(files)?;
    stderr::say(format!("wrote the results of {} simulated students to {place}", args.students));
    stdout::print(&format!(
        "simulated students: {}; collect them with: saute class collect {place}/*.csv\n",
        args.students
    ))?;
    Ok(ExitCode::SUCCESS)
}

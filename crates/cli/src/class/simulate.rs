//! `saute class simulate`.

use std::path::PathBuf;
use std::process::ExitCode;
use std::sync::Arc;

use saute_study::class::{ResultRow, to_csv};
use saute_study::simulated::SimulatedClass;

use crate::commands::open;
use crate::error::CliError;
use crate::input::data_library::DataLibrary;
use crate::output::out_dir::OutDir;
use crate::output::{stderr, stdout};
use crate::simulated_people;

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
    let codes = (1..=args.students).map(SimulatedClass::code);
    let name = |code: &str| format!("{}-{code}.csv", scenario.id);
    if let Some(there) = codes.map(|code| args.out.join(name(&code))).find(|path| path.exists()) {
        let message = "is there already, and may be the result of a student";
        return Err(CliError::place(there.display(), message, "name another folder: --out DIR"));
    }
    let out = OutDir::prepare(&args.out)?;
    let class = SimulatedClass { scenario: Arc::clone(&scenario), seed: args.seed };
    let row = |number| class.row(number, &data.library);
    let rows = simulated_people::all(args.students, "student", &args.scenario, row)?;
    let of_row = |row: ResultRow| {
        let student = row.student.clone().unwrap_or_default();
        (name(&student), to_csv(&[row]).into_bytes())
    };
    let files = rows.into_iter().map(of_row).collect();
    let place = out.place();
    out.fill(files)?;
    stderr::say(format!("wrote the results of {} simulated students to {place}", args.students));
    stdout::print(&format!(
        "simulated students: {}; collect them with: saute class collect {place}/*.csv\n",
        args.students
    ))?;
    Ok(ExitCode::SUCCESS)
}

//! `saute study simulate`.

use std::path::PathBuf;
use std::process::ExitCode;

use saute_study::{Simulation, dictionary, to_csv};

use super::load;
use crate::error::CliError;
use crate::input::data_library::DataLibrary;
use crate::output::out_dir::OutDir;
use crate::output::{stderr, stdout};
use crate::simulated_people;

/// `saute study simulate`.
#[derive(Debug, clap::Args)]
pub struct SimulateArgs {
    /// Protocol file, or id of a shipped protocol (`saute list studies`).
    #[arg(value_name = "PROTOCOL")]
    pub protocol: String,
    /// Number of simulated participants.
    #[arg(long, value_name = "N", default_value_t = 12, value_parser = clap::value_parser!(u32).range(1..=200))]
    pub participants: u32,
    /// Seed of all draws: the same seed gives the same logs.
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub seed: u64,
    /// Folder of the logs; created if missing.
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
}

/// Lets simulated participants take part, and writes their logs.
pub fn run(args: &SimulateArgs, data: &DataLibrary) -> Result<ExitCode, CliError> {
    let protocol = load(&args.protocol, data)?;
    let out = OutDir::prepare(&args.out)?;
    let simulation = Simulation { protocol, seed: args.seed };
    let log = |number| simulation.log(number, &data.library);
    let logs = simulated_people::all(args.participants, "participant", &args.protocol, log)?;
    let mut files = dictionary_files();
    for (participant, rows) in logs {
        files.push((format!("study-{participant}.csv"), to_csv(&rows, true).into_bytes()));
    }
    let place = out.place();
    out.fill(files)?;
    stderr::say(format!("wrote {} logs of simulated participants to {place}", args.participants));
    stdout::print(&format!(
        "simulated participants: {}; analyse them with: saute study analyse {place}\n",
        args.participants
    ))?;
    Ok(ExitCode::SUCCESS)
}

/// The data dictionary, for programs and for people.
fn dictionary_files() -> Vec<(String, Vec<u8>)> {
    vec![
        ("data-dictionary.csv".to_owned(), dictionary::csv().into_bytes()),
        ("data-dictionary.md".to_owned(), dictionary::page().into_bytes()),
    ]
}

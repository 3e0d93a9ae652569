//! `saute study`: the window in study mode, simulated participants, and the analysis of logs.

mod analyse;
mod curves_plot;
mod page;
mod simulate;
mod tables;

use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::Arc;

use clap::Subcommand;
use saute_controls::kept::log_file::study_in_folder;
use saute_study::{Protocol, shipped};

use crate::args::HandArgs;
use crate::commands::open;
use crate::error::CliError;
use crate::input::data_library::DataLibrary;
use crate::input::text_file;

pub use analyse::AnalyseArgs;
pub use simulate::SimulateArgs;

/// `saute study`.
#[derive(Debug, clap::Args)]
#[command(args_conflicts_with_subcommands = true, subcommand_negates_reqs = true)]
pub struct StudyArgs {
    /// Simulated participants and analysis.
    #[command(subcommand)]
    pub command: Option<StudyCommand>,
    /// Protocol file, or id of a shipped protocol (`saute list studies`).
    #[arg(value_name = "PROTOCOL", required = true)]
    pub protocol: Option<String>,
    /// Code of the participant: 1 to 12 letters, digits and hyphens, as P07. No names.
    #[arg(long, value_name = "CODE", required = true)]
    pub participant: Option<String>,
    /// Folder of the log study-CODE.csv and its data dictionary. A log that is there is gone on with.
    #[arg(long, value_name = "DIR", required = true)]
    pub out: Option<PathBuf>,
}

/// Simulated participants and analysis.
#[derive(Debug, Subcommand)]
pub enum StudyCommand {
    /// Lets simulated participants take part: rule-based cooks, for trying a protocol and its analysis. They prove nothing about
    /// people, and every row states it.
    Simulate(SimulateArgs),
    /// Makes learning curves and a comparison before and after the cook at a real stove from logs: CSV files and report.html.
    Analyse(AnalyseArgs),
}

/// Opens the window in study mode, or runs the command.
pub fn run(args: StudyArgs, data: DataLibrary, hands: HandArgs) -> Result<ExitCode, CliError> {
    match args.command {
        Some(StudyCommand::Simulate(args)) => simulate::run(&args, &data),
        Some(StudyCommand::Analyse(args)) => analyse::run(&args),
        None => window(args, data, hands),
    }
}

fn window(args: StudyArgs, data: DataLibrary, hands: HandArgs) -> Result<ExitCode, CliError> {
    let StudyArgs { protocol: Some(protocol), participant: Some(code), out: Some(out), .. } = args else {
        return Err(CliError::place(
            "saute study",
            "needs a protocol, --participant and --out",
            "see: saute study --help",
        ));
    };
    let protocol = load(&protocol, &data)?;
    let participant = open::participant("--participant", &code)?;
    let start = study_in_folder(protocol, participant, &out).map_err(|message| {
        CliError::place(
            format!("--out {}", out.display()),
            message,
            "name another folder or code, or the protocol as it was",
        )
    })?;
    open::run_study(data, start, hands)
}

/// Reads and checks the protocol with a path or an id. A file takes precedence over an id of the same name.
fn load(name: &str, data: &DataLibrary) -> Result<Arc<Protocol>, CliError> {
    let path = Path::new(name);
    let text = match shipped::text(name) {
        Some(text) if !path.is_file() => text.to_owned(),
        _ if path.exists() => text_file::read(path)?,
        _ => {
            let remedy = format!("name a .toml file or a shipped protocol: {}", shipped::names());
            return Err(CliError::place(name, "there is no such file and no protocol with this id", remedy));
        }
    };
    Ok(Arc::new(Protocol::parse(&text, name, &data.library)?))
}

//! `saute study analyse`.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use saute_study::analysis::Mixed;
use saute_study::{Analysis, LogError, LogRow, from_csv};

use super::{page, tables};
use crate::error::CliError;
use crate::input::{folder, text_file};
use crate::output::out_dir::OutDir;
use crate::output::{json, stderr, stdout};

/// `saute study analyse`.
#[derive(Debug, clap::Args)]
pub struct AnalyseArgs {
    /// Folders with logs (study-*.csv), or logs.
    #[arg(value_name = "DIR|FILE", required = true)]
    pub logs: Vec<PathBuf>,
    /// Folder for curves.csv, before-after.csv, participants.csv and report.html; created if missing.
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Seed of the bootstrap.
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub seed: u64,
    /// Prints the numbers as JSON.
    #[arg(long)]
    pub json: bool,
}

/// Largest log that is read [MiB] (chosen: fifty trials have 20 kB).
const LARGEST_MIB: u64 = 8;

/// Analyses logs.
pub fn run(args: &AnalyseArgs) -> Result<ExitCode, CliError> {
    let files = files(&args.logs)?;
    let mut rows = Vec::new();
    for file in &files {
        rows.extend(read(file)?);
    }
    let analysis = Analysis::of(&rows, args.seed).map_err(|mixed| refused(&mixed, &args.logs))?;
    if let Some(dir) = &args.out {
        let out = OutDir::prepare(dir)?;
        let place = out.place();
        let page = ("report.html".to_owned(), page::page(&analysis).into_bytes());
        out.fill(tables::files(&analysis)?.into_iter().chain([page]).collect())?;
        stderr::say(format!("wrote {place}/report.html and tables"));
    }
    stdout::print(&if args.json { json::text(&analysis)? } else { tables::text(&analysis) })?;
    Ok(ExitCode::SUCCESS)
}

/// The logs that folders and files name, sorted, each once.
fn files(named: &[PathBuf]) -> Result<Vec<PathBuf>, CliError> {
    let mut files = Vec::new();
    for path in named {
        if !path.is_dir() {
            files.push(path.clone());
            continue;
        }
        let error = |e: std::io::Error| {
            CliError::place(path.display(), format!("cannot be read: {e}"), "name a folder of logs")
        };
        let found = folder::files(path, is_log).map_err(error)?;
        if found.is_empty() {
            return Err(CliError::place(path.display(), "has no log", "name a folder with study-CODE.csv files"));
        }
        files.extend(found);
    }
    files.sort();
    files.dedup();
    Ok(files)
}

fn is_log(name: &str) -> bool {
    name.starts_with("study-") && name.ends_with(".csv")
}

fn read(path: &Path) -> Result<Vec<LogRow>, CliError> {
    let bytes = text_file::bytes(path, LARGEST_MIB, ".csv", "a participant's log")?;
    let place = path.display().to_string();
    from_csv(&place, &String::from_utf8_lossy(&bytes)).map_err(|LogError { file, line, message }| {
        let (message, remedy) = message.rsplit_once("; ").unwrap_or((&message, "name a participant's log"));
        CliError::place(format!("{file}:{line}"), message, remedy)
    })
}

fn refused(mixed: &Mixed, logs: &[PathBuf]) -> CliError {
    let text = mixed.to_string();
    let (message, remedy) = text.split_once("; ").unwrap_or((&text, "name the logs of one study"));
    let named: Vec<String> = logs.iter().map(|path| path.display().to_string()).collect();
    CliError::place(named.join(" "), message, remedy)
}

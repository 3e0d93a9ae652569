//! `saute bench paper`: repeats the tables of the 2013 Interactive Cooking Simulator.
//!
//! A cycle is `Kitchen::advance_frame`, as in `saute cook`: rigid steps of 1/240 s and a tick of heat in every sixth
//! cycle. Each scene is a recipe in which carrots and shrimps fall into a hot pan one after another. Bodies do not
//! sleep, and overlaps are checked while the clock is stopped. A test plays the same recipe as a cook and compares
//! the rise of the core temperatures. With many pieces the solver of the rigid bodies takes most of a cycle; links
//! between touching foods are found among patches sorted along one axis.

mod original;
mod row;
mod scaling;
mod scene;
mod stopwatch;
mod table;

use std::process::ExitCode;

use saute_kitchen::Library;
use serde::Serialize;

use crate::error::CliError;
use crate::exit_code;
use crate::output::progress::Progress;
use crate::output::{json, stdout};

/// `saute bench paper`.
#[derive(Debug, clap::Args)]
pub struct BenchPaperArgs {
    /// Prints the numbers as JSON.
    #[arg(long)]
    pub json: bool,
}

/// All numbers, as `--json` prints them.
#[derive(Debug, Serialize)]
struct PaperBench {
    rows: Vec<row::Row>,
    original_engine: original::OriginalEngine,
    scaling: scaling::Scaling,
    /// True if every goal is met.
    goals_met: bool,
}

/// Measures and prints the numbers.
pub fn run(args: &BenchPaperArgs, library: &Library) -> Result<ExitCode, CliError> {
    let cases = row::cases();
    let progress = Progress::over((cases.len() + scaling::SCENES) as u64);
    let mut rows = Vec::new();
    for case in &cases {
        progress.next(case.scene.in_words());
        rows.push(row::measure(case, library)?);
    }
    let scaling = scaling::measure(library, &progress)?;
    drop(progress);
    let goals_met = rows.iter().all(|r| r.met != Some(false)) && scaling.met;
    let bench = PaperBench { rows, original_engine: original::MEASURED, scaling, goals_met };
    stdout::print(&if args.json { json::text(&bench)? } else { table::text(&bench) })?;
    Ok(exit_code::of_goal(goals_met))
}

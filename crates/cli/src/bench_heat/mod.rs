//! `saute bench heat`: speed and accuracy of the solver on one thread.

mod brick;
mod kernel;
mod steak;
mod table;

use std::process::ExitCode;

use saute_kitchen::Library;
use serde::Serialize;

use crate::error::CliError;
use crate::output::{json, stderr, stdout};

/// `saute bench heat`.
#[derive(Debug, clap::Args)]
pub struct BenchHeatArgs {
    /// Measures the brick alone: a second that states how fast a machine is.
    #[arg(long)]
    pub brick: bool,
    /// Prints the numbers as JSON.
    #[arg(long)]
    pub json: bool,
}

/// All numbers, as `--json` prints them.
#[derive(Debug, Serialize)]
struct HeatBench {
    brick: brick::BrickBench,
    /// Node updates per second, one per node and stage, on a mesh as large as the brick's [1/s].
    updates_per_s: f64,
    /// Memory traffic at 10⁶ nodes, each array of a stage counted once, over the bandwidth of a STREAM triad [-].
    bandwidth_fraction: f64,
    scaling: Scaling,
    steak: steak::SteakBench,
}

/// Time against mesh size.
#[derive(Debug, Serialize)]
struct Scaling {
    #[serde(flatten)]
    steps: kernel::StepTimes,
    /// Runs of the brick on finer and finer meshes.
    runs: Vec<brick::WholeRun>,
    /// Time of a run of the brick with an error of 0.1 K, interpolated [s].
    seconds_to_0_1_k: Option<f64>,
}

/// The brick alone, as `--brick --json` prints it.
#[derive(Debug, Serialize)]
struct BrickOnly {
    brick: brick::BrickBench,
}

/// Measures and prints the numbers.
pub fn run(args: &BenchHeatArgs, library: &Library) -> Result<ExitCode, CliError> {
    stderr::say("brick: exact series, time loop");
    let exact = brick::exact();
    let brick = brick::measure(&exact, library)?;
    if args.brick {
        let text = if args.json { json::text(&BrickOnly { brick })? } else { table::brick_text(&brick) };
        stdout::print(&text)?;
        return Ok(ExitCode::SUCCESS);
    }
    stderr::say("brick: runs on finer and finer meshes");
    let runs = brick::whole_runs(&exact, library)?;
    stderr::say("kernel: 10⁴ to 10⁶ nodes");
    let steps = kernel::step_times();
    stderr::say("memory: STREAM triad");
    let bandwidth_fraction = kernel::bandwidth(&steps) / kernel::triad_bandwidth();
    stderr::say("steak: a whole cook");
    let bench = HeatBench {
        updates_per_s: kernel::updates_per_s(&steps),
        bandwidth_fraction,
        scaling: Scaling { steps, seconds_to_0_1_k: brick::seconds_to(0.1, &runs), runs },
        brick,
        steak: steak::measure(library)?,
    };
    stdout::print(&if args.json { json::text(&bench)? } else { table::text(&bench) })?;
    Ok(ExitCode::SUCCESS)
}

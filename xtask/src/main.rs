//! Work on this repository that is more than a few lines of shell; `./test.sh` calls it.

mod durations;
mod error;
mod measured;
mod pool;
mod programs;
mod report;
mod run_tests;

use std::process::ExitCode;

use clap::{Parser, Subcommand};

use crate::error::TaskError;

/// Runs test programs, and keeps the budget of the day.
#[derive(Parser)]
struct Arguments {
    #[command(subcommand)]
    task: Task,
}

#[derive(Subcommand)]
enum Task {
    /// Runs the test programs of the workspace, the longest first, one on each core.
    Tests(run_tests::Tests),
    /// Prints how long each step of a run took, and which are beyond their budgets; fails where more was counted than is allowed.
    Durations(report::Report),
}

fn main() -> ExitCode {
    let done = match Arguments::parse().task {
        Task::Tests(tests) => tests.run(),
        Task::Durations(report) => report.run(),
    };
    match done {
        Ok(code) => code,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::from(match error {
                TaskError::Failed(_) => 1,
                _ => 2,
            })
        }
    }
}

//! The exit codes of the command.

use std::process::ExitCode;

use crate::error::CliError;

/// Exit code of a run that ends but falls short: stopped by `max_s`, a failed case, a missed goal, a device that did not work.
const FELL_SHORT: u8 = 1;
/// Exit code for wrong usage and wrong input.
const FAILED: u8 = 2;

/// Exit code of a run that a signal ended (128 + SIGINT, as shells report it).
const INTERRUPTED: u8 = 130;

/// Returns 0 for a run that meets its goal and 1 for one that falls short.
pub fn of_goal(is_met: bool) -> ExitCode {
    if is_met { ExitCode::SUCCESS } else { ExitCode::from(FELL_SHORT) }
}

/// Returns the exit code for wrong usage and wrong input.
pub fn failed() -> ExitCode {
    ExitCode::from(FAILED)
}

/// Returns the exit code of a run that a signal ended.
pub fn interrupted() -> ExitCode {
    ExitCode::from(INTERRUPTED)
}

/// Returns the exit code for an error.
pub fn of_error(error: &CliError) -> ExitCode {
    match error {
        CliError::Interrupted { .. } | CliError::SweepInterrupted { .. } | CliError::PlanInterrupted => interrupted(),
        CliError::Trouble { .. } => of_goal(false),
        _ => failed(),
    }
}

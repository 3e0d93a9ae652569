//! The exit codes of the command.

use std::process::ExitCode;

/// Exit code of a run that ends but falls short: stopped by `max_s`, a failed case, a missed goal.
const FELL_SHORT: u8 = 1;
/// Exit code for wrong usage and wrong input.
const FAILED: u8 = 2;

/// Returns 0 for a run that meets its goal and 1 for one that falls short.
pub fn of_goal(is_met: bool) -> ExitCode {
    if is_met { ExitCode::SUCCESS } else { ExitCode::from(FELL_SHORT) }
}

/// Returns the exit code for wrong usage and wrong input.
pub fn failed() -> ExitCode {
    ExitCode::from(FAILED)
}

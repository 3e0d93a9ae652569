//! Simulated people who cook side by side, with progress.

use std::fmt::Display;

use crate::error::CliError;
use crate::output::progress::Progress;
use crate::workers::map_all;

/// Lets people with the numbers 1 to `count` cook; `who` is what one is called, `given` names the file that all follow.
///
/// # Errors
///
/// If one of them cannot cook what the file sets out.
pub fn all<T: Send, E: Display + Send>(
    count: u32,
    who: &str,
    given: &str,
    one: impl Fn(u32) -> Result<T, E> + Sync,
) -> Result<Vec<T>, CliError> {
    let progress = Progress::over(count.into());
    let numbers: Vec<u32> = (1..=count).collect();
    let cooked = map_all(&numbers, |_, number| {
        let cooked = one(*number);
        progress.next(format!("{who} {number} of {count}"));
        cooked
    });
    drop(progress);
    let cannot = |error: E| CliError::place(given, error.to_string(), "set out one piece of food that can be cooked");
    cooked.into_iter().map(|one| one.map_err(cannot)).collect()
}

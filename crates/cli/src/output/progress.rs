//! A progress bar on a terminal.

use std::io::IsTerminal;

use indicatif::{ProgressBar, ProgressStyle};
use saute_recipe::Cook;

use crate::wording::clock;

/// Ticks between two updates (chosen: smooth to the eye, no cost in time).
const EVERY: u64 = 50;

/// A bar over simulated time or parts; none if stderr is not a terminal.
#[derive(Debug)]
pub struct Progress(Option<ProgressBar>);

impl Progress {
    /// Starts the bar of a cook, over the steps of its recipe, or over the seconds of the session that it plays again.
    pub fn start(cook: &Cook) -> Self {
        Self::over(end_s(cook).unwrap_or(cook.runner.recipe().steps.len() as u64))
    }

    /// Starts a bar over a number of parts.
    pub fn over(parts: u64) -> Self {
        let style =
            ProgressStyle::with_template("{bar:24} {wide_msg}").unwrap_or_else(|_| ProgressStyle::default_bar());
        let bar = || ProgressBar::new(parts).with_style(style);
        Self(std::io::stderr().is_terminal().then(bar))
    }

    /// Starts the next part, described by `what`.
    pub fn next(&self, what: String) {
        if let Some(bar) = &self.0 {
            bar.inc(1);
            bar.set_message(what);
        }
    }

    /// Shows the time of the cook and the condition that it waits for.
    pub fn show(&self, cook: &Cook) {
        let Some(bar) = &self.0 else { return };
        if !cook.kitchen.tick().is_multiple_of(EVERY) {
            return;
        }
        if let Some(end_s) = end_s(cook) {
            bar.set_position(cook.kitchen.time_s() as u64);
            bar.set_message(format!("{} of {}", clock(cook.kitchen.time_s()), clock(end_s as f64)));
        } else {
            let (done, time) = (cook.runner.waiting_step(), clock(cook.kitchen.time_s()));
            bar.set_position(done as u64);
            let all = cook.runner.recipe().steps.len();
            bar.set_message(format!("{time}, step {done} of {all}; next: {}", cook.runner.waiting_for()));
        }
    }
}

/// End of the session that a cook plays again [s]; none if it cooks a recipe.
fn end_s(cook: &Cook) -> Option<u64> {
    cook.recording().map(|recording| recording.moment().time_s() as u64)
}

impl Drop for Progress {
    /// Removes the bar before the result or the error is printed.
    fn drop(&mut self) {
        if let Some(bar) = &self.0 {
            bar.finish_and_clear();
        }
    }
}

//! The progress bar of a sweep: rows, rate and time left.

use std::io::IsTerminal;
use std::time::Instant;

use indicatif::{ProgressBar, ProgressStyle};
use saute_sweep_folder::Tally;

use crate::wording::duration;

/// The bar; none if stderr is not a terminal.
#[derive(Debug)]
pub struct Bar {
    bar: Option<ProgressBar>,
    started: Instant,
}

impl Bar {
    /// Starts the bar.
    pub fn start(tally: Tally) -> Self {
        let style =
            ProgressStyle::with_template("{bar:24} {wide_msg}").unwrap_or_else(|_| ProgressStyle::default_bar());
        let bar = || ProgressBar::new(tally.rows).with_style(style);
        let bar = Self { bar: std::io::stderr().is_terminal().then(bar), started: Instant::now() };
        bar.show(tally);
        bar
    }

    /// Shows how far it is.
    pub fn show(&self, tally: Tally) {
        if let Some(bar) = &self.bar {
            bar.set_position(tally.done);
            bar.set_message(words(tally, self.started));
        }
    }
}

impl Drop for Bar {
    /// Removes the bar before the result or the error is printed.
    fn drop(&mut self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }
}

fn words(tally: Tally, started: Instant) -> String {
    let since = started.elapsed();
    let rows = format!("{} of {} rows", tally.done, tally.rows);
    let failed = if tally.failed > 0 { format!(", {} failed", tally.failed) } else { String::new() };
    match tally.left_s(since) {
        Some(left) => format!("{rows}{failed}, {:.1} a second, {} left", tally.rate(since), duration(left)),
        None => rows + &failed,
    }
}

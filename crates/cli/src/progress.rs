//! How far a cook or a bench is, on a terminal.

use std::io::IsTerminal;

use indicatif::{ProgressBar, ProgressStyle};
use saute_recipe::Cook;

use crate::wording::duration;

/// Ticks between two looks: often enough to move, seldom enough to cost nothing.
const EVERY: u64 = 50;

/// A bar over simulated time or parts; nothing where stderr is no terminal.
#[derive(Debug)]
pub struct Progress(Option<ProgressBar>);

impl Progress {
    /// Starts the bar of a cook.
    pub fn start(max_s: f64) -> Self {
        Self::over(max_s.ceil() as u64)
    }

    /// Starts a bar over so many parts.
    pub fn over(parts: u64) -> Self {
        let style =
            ProgressStyle::with_template("{bar:24} {wide_msg}").unwrap_or_else(|_| ProgressStyle::default_bar());
        let bar = || ProgressBar::new(parts).with_style(style);
        Self(std::io::stderr().is_terminal().then(bar))
    }

    /// One part more is done; `what` comes now.
    pub fn next(&self, what: String) {
        if let Some(bar) = &self.0 {
            bar.inc(1);
            bar.set_message(what);
        }
    }

    /// Shows where the cook is and what it waits for.
    pub fn show(&self, cook: &Cook) {
        let Some(bar) = &self.0 else { return };
        if cook.kitchen.tick().is_multiple_of(EVERY) {
            let (time, most) = (cook.kitchen.time_s(), cook.runner.recipe().max_s);
            bar.set_position(time as u64);
            bar.set_message(format!(
                "{} of at most {}; next: {}",
                duration(time),
                duration(most),
                cook.runner.waiting_for()
            ));
        }
    }
}

impl Drop for Progress {
    /// The bar makes room for the result, or for the error.
    fn drop(&mut self) {
        if let Some(bar) = &self.0 {
            bar.finish_and_clear();
        }
    }
}

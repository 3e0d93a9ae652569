//! How far a sweep is.

use std::time::Duration;

/// How far a sweep is.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Tally {
    /// Rows of the sweep [-].
    pub rows: u64,
    /// Rows whose results are in the folder [-].
    pub done: u64,
    /// Those of them that could not be cooked [-].
    pub failed: u64,
    /// Rows that came since the folder was opened [-].
    pub fresh: u64,
}

impl Tally {
    /// Returns the rate since the folder was opened, a time ago [rows/s].
    pub fn rate(&self, since: Duration) -> f64 {
        self.fresh as f64 / since.as_secs_f64().max(1e-9)
    }

    /// Returns the time that the rest takes at this rate [s]; none before the first row.
    pub fn left_s(&self, since: Duration) -> Option<f64> {
        (self.fresh > 0).then(|| (self.rows - self.done) as f64 / self.rate(since))
    }

    /// Returns true if every row is there.
    pub fn is_complete(&self) -> bool {
        self.done == self.rows
    }
}

//! The time over which heat flows at once.

use crate::TICK_S;

/// One tick, or several at once where a coarser model takes longer steps.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Lapse {
    /// Number of ticks [-].
    pub(crate) ticks: u64,
}

impl Lapse {
    /// One tick.
    pub(crate) const TICK: Self = Self { ticks: 1 };

    /// Its length [s].
    pub(crate) fn s(self) -> f64 {
        self.ticks as f64 * TICK_S
    }
}

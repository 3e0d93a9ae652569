//! An instant of a session.

use saute_kitchen::FRAME_S;
use serde::{Deserialize, Serialize};

/// An instant of a session: a frame, and what was carried out in it so far.
///
/// Moments of one recording are ordered by time.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Deserialize, Serialize)]
pub struct Moment {
    /// Frames since the start.
    pub frame: u64,
    /// Number of entries that were carried out.
    pub entries: usize,
    /// True if the recipe's steps that were due at this frame were carried out.
    pub steps_done: bool,
}

impl Moment {
    /// Time [s].
    pub fn time_s(self) -> f64 {
        self.frame as f64 * FRAME_S
    }
}

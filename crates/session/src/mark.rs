//! Marks: what was done, for the plot.

use saute_kitchen::Command;
use saute_recipe::Moment;
use saute_recipe::session::Done;

/// An event, for the plot.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize)]
pub struct Mark {
    /// When [s].
    pub time_s: f64,
    /// What.
    pub done: Done,
    /// The instant after it.
    pub at: Moment,
    /// The step as a recipe states it, if a recipe's step did it; empty for what a hand did, which the recording has.
    pub step: String,
}

impl Mark {
    /// Returns true if food went into the pan.
    pub(super) fn is_put(&self) -> bool {
        matches!(self.done, Done::Command(Command::Put { .. }))
    }

    /// Returns true if food was turned over.
    pub(super) fn is_flip(&self) -> bool {
        matches!(self.done, Done::Command(Command::Flip { .. }))
    }

    /// Returns true if food was taken out of the pan.
    pub(super) fn is_rest(&self) -> bool {
        matches!(self.done, Done::Command(Command::Rest { .. }))
    }
}

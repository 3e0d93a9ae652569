//! What the line keeps from frame to frame.

use super::time_left::TimeLeft;

/// What the line keeps from frame to frame.
#[derive(Clone, Debug, Default)]
pub struct NowMemory {
    /// How long what is waited for takes.
    pub left: TimeLeft,
    /// What is to be done now: a verb, and the sentence with its reason.
    pub order: Option<(String, String)>,
}

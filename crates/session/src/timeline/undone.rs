//! What an undo took back.

use saute_recipe::session::Done;

/// What was undone or done again.
#[derive(Clone, Debug, PartialEq)]
pub enum Undone {
    /// An act.
    Act(Done),
    /// The beginning of another cook.
    Beginning,
}

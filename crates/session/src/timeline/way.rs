//! The ways that a cook went, and how they are seen side by side.

use saute_kitchen::Kitchen;
use saute_recipe::recorder::Row;

/// Branches that are kept next to the one that is shown (chosen: four ways fit side by side).
pub const MOST_BESIDE: usize = 3;

/// Which of the ways that a cook went: it stays the same while others are gone over to.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Way {
    /// Its place among the ways from 0: the lowest that was free when it began, below [`MOST_BESIDE`] + 1.
    pub slot: usize,
    /// A number that no other way has.
    pub id: u64,
}

/// A way as it is seen next to the others.
pub struct WayBeside<'a> {
    /// Which way it is.
    pub way: Way,
    /// Its place among the branches; none for the one that goes on.
    pub place: Option<usize>,
    /// The kitchen as it is seen.
    pub kitchen: &'a Kitchen,
    /// Series up to its end.
    pub rows: &'a [Row],
    /// How far it is with respect to the instant that is shown.
    pub stand: Stand,
}

/// Progress of a way next to others.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Stand {
    /// The one that goes on.
    Live,
    /// It has not parted from the one that goes on; it does at this time [s].
    Same(f64),
    /// At the instant that is shown.
    Here,
    /// On its way to the instant that is shown: it is seen as it was at this time [s].
    CatchingUp(f64),
    /// It ended before, at this time [s], and is seen as it was then.
    Ended(f64),
}

//! A branch: another way that the cook went.

use saute_recipe::Recording;
use saute_recipe::session::{Deed, Done, Entry};

use super::line::Line;
use super::travel::Travel;
use super::way::Way;

/// A way next to the one that is shown.
pub(super) struct Branch {
    pub(super) way: Way,
    pub(super) line: Line,
    /// Where it is seen next to the others.
    pub(super) seen: Option<Travel>,
}

/// What a branch is called by: the act by which it differs from the one that is shown.
#[derive(Clone, Debug, PartialEq)]
pub struct BranchName {
    /// The act; none if nothing was done that differs.
    pub done: Option<Done>,
    /// When it was done, or when the two part [s].
    pub at_s: f64,
}

/// Number of the first entries that two recordings share.
pub(super) fn shared_entries(one: &Recording, other: &Recording) -> usize {
    one.entries().iter().zip(other.entries()).take_while(|(a, b)| a == b).count()
}

/// The act by which a recording differs from another one.
pub(super) fn name_of(recording: &Recording, other: &Recording) -> BranchName {
    let same = shared_entries(recording, other);
    let own = recording.entries()[same..].iter().find(|entry| entry.deed != Deed::TakeOver);
    let theirs = other.entries().get(same);
    let at = own.or(theirs).map_or_else(|| recording.moment().time_s(), Entry::time_s);
    BranchName { done: own.map(|entry| Done::from(&entry.deed)), at_s: at }
}

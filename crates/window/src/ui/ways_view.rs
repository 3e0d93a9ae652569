//! Ways side by side: when they are shown, and the pans of those next to the one that goes on.

use saute_picture::stage::Stage;
use std::collections::BTreeMap;

/// What the window keeps of ways side by side.
#[derive(Debug, Default)]
pub(crate) struct WaysView {
    /// True if they are to be shown as soon as there are two.
    pub(crate) on: bool,
    /// True while one is on its way to the instant that is shown.
    pub(crate) catch_up: bool,
    /// The skins of each of them, by its number.
    pub(crate) stages: BTreeMap<u64, Stage>,
    /// Number of the way whose skins the window's own stage has.
    pub(crate) live: u64,
}

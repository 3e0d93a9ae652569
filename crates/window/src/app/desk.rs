//! What is over the scene.

use crate::panels::memory::PanelMemory;
use saute_controls::act::Card;
use saute_controls::spoken::notice::Notice;

/// What is over the scene: a card, notices, and what panels keep.
#[derive(Default)]
pub(crate) struct Desk {
    /// The card that is open.
    pub(crate) card: Option<Card>,
    pub(crate) notice: Notice,
    /// What panels keep from frame to frame.
    pub(crate) memory: PanelMemory,
}

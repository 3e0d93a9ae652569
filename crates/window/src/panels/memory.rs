//! What panels keep from frame to frame.

use std::collections::BTreeSet;

use crate::panels::cards::result::CutOfResult;
use crate::panels::guided::Entries;
use crate::panels::host_panels::HostMemory;
use crate::panels::pantry::PantryMemory;
use crate::panels::section_read::Inside;
use crate::panels::ways::memory::WaysMemory;
use saute_controls::act::{Act, ViewAct};
use saute_controls::context::PanelContext;
use saute_controls::now::now_memory::NowMemory;

/// Which part of the drawer is open on a narrow window.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Drawer {
    /// Hob, hands, time.
    #[default]
    Cook,
    /// What is inside.
    Inside,
    /// Food and pan.
    Food,
    /// List of the pieces.
    Pieces,
}

impl Drawer {
    pub(super) const ALL: [Self; 4] = [Self::Cook, Self::Inside, Self::Food, Self::Pieces];

    /// True unless a study or a lesson hides what it shows.
    pub(super) fn is_offered(self, state: &PanelContext) -> bool {
        match self {
            Self::Cook => true,
            Self::Inside | Self::Pieces => !state.is_blind(),
            Self::Food => !state.hides(&Act::View(ViewAct::Pantry)),
        }
    }

    pub(super) fn name(self, state: &PanelContext) -> &'static str {
        match self {
            Self::Cook => state.settings.language.text("drawer.cook"),
            Self::Inside => state.settings.language.text("drawer.inside"),
            Self::Food => state.settings.language.text("top.food"),
            Self::Pieces => state.settings.language.text("top.pieces"),
        }
    }
}

/// What panels keep from frame to frame, each its own part.
#[derive(Default)]
pub struct PanelMemory {
    /// The section and what was read with it.
    pub inside: Inside,
    /// The open part of the drawer of a narrow window.
    pub drawer: Drawer,
    /// Groups of which the list shows every piece.
    pub unfolded: BTreeSet<String>,
    /// What the line keeps.
    pub now: NowMemory,
    /// What the pantry keeps.
    pub pantry: PantryMemory,
    /// What was typed into the search of the help.
    pub search: String,
    /// What is kept of ways side by side.
    pub ways: WaysMemory,
    /// What was entered on the card of a study or a lesson.
    pub answers: Entries,
    /// The picture of the result.
    pub result: CutOfResult,
    /// What only a desktop, or only a page, keeps.
    pub(crate) host: HostMemory,
}

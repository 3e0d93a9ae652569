//! What is kept of ways side by side from frame to frame.

use crate::panels::cut_picture::CutPicture;
use crate::panels::ways::plot::Quantity;
use egui::{Rect, Ui, UiBuilder};
use std::collections::BTreeMap;

/// What is kept from frame to frame.
#[derive(Default)]
pub struct WaysMemory {
    /// What the curves show.
    pub(crate) quantity: Quantity,
    /// Number of the way that is shown next to the one that goes on, where there is room for one.
    pub(crate) other: Option<u64>,
    /// True if there is no room for all of them.
    pub(crate) pages: bool,
    /// The cuts, by the number of the way.
    pub(crate) cuts: BTreeMap<u64, CutPicture>,
}

/// Shows a part in its rectangle.
pub(crate) fn within(ui: &mut Ui, rect: Rect, name: &str, content: impl FnOnce(&mut Ui)) {
    let mut child = ui.new_child(UiBuilder::new().id_salt(name).max_rect(rect));
    child.set_clip_rect(rect.intersect(ui.clip_rect()));
    content(&mut child);
}

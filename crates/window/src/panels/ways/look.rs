//! How a way is distinguished from the others: its piece and the style of its lines.

use egui_plot::LineStyle;
use saute_controls::context::PanelContext;
use saute_kitchen::Piece;
use saute_session::timeline::WayBeside;

/// The piece of a way that is the one that the panels show.
pub(crate) fn piece<'a>(state: &PanelContext, way: &WayBeside<'a>) -> Option<&'a Piece> {
    way.kitchen.piece(&state.session.shown_id()).or_else(|| way.kitchen.pieces().first())
}

/// The line style of a way, by its slot: no two are the same.
pub(crate) fn style(slot: usize) -> LineStyle {
    match slot {
        0 => LineStyle::Solid,
        1 => LineStyle::Dashed { length: 12.0 },
        2 => LineStyle::Dotted { spacing: 6.0 },
        _ => LineStyle::Dashed { length: 4.0 },
    }
}

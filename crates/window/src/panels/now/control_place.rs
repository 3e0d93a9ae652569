//! Where the control of an act is, so that it can be lit.

use egui::{Id, LayerId, Order, Rect, Stroke, StrokeKind, Ui};

use crate::ui::theme;
use saute_controls::act::Act;

/// Notes where the control of an act is.
pub fn note(ui: &Ui, act: &Act, rect: Rect) {
    ui.ctx().data_mut(|data| data.insert_temp(id_of(act), rect));
}

/// Lights the control of an act, if it was shown.
pub(super) fn light(ui: &Ui, act: &Act) {
    let Some(rect) = ui.ctx().data(|data| data.get_temp::<Rect>(id_of(act))) else { return };
    let over = ui.ctx().layer_painter(LayerId::new(Order::Middle, Id::unique("lit-control")));
    over.rect_stroke(rect.expand(2.0), 9.0, Stroke::new(2.0, theme::of(ui).accent), StrokeKind::Outside);
}

fn id_of(act: &Act) -> Id {
    Id::unique(("control", format!("{act:?}")))
}

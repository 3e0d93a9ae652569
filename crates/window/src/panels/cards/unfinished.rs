//! The card that offers to go on with a cook.

use egui::{Id, Modal, Rect, Ui};

use crate::ui::aloud::heading;
use crate::ui::theme;
use saute_controls::act::{Act, Acts, TimeAct};
use saute_controls::context::PanelContext;
use saute_words::clock::clock;

/// Width of the card at most [points].
const WIDTH: f32 = 380.0;

/// Shows the card over everything; only its buttons close it.
pub fn show(state: &PanelContext, time_s: f64, ui: &Ui, acts: &mut Acts, whole: Rect) {
    let (l, palette) = (state.settings.language, theme::of(ui));
    Modal::new(Id::unique("unfinished")).frame(palette.panel().fill(palette.solid)).show(ui.ctx(), |ui| {
        ui.set_width((whole.width() - 56.0).min(WIDTH));
        heading(ui, l.text("unfinished.title"));
        ui.label(l.fill("unfinished.how", &[("time", &clock(time_s))]));
        ui.add_space(6.0);
        ui.horizontal(|ui| {
            for (key, first) in [("unfinished.go_on", true), ("unfinished.leave", false)] {
                if ui.add(palette.button(l.text(key), first)).clicked() {
                    acts.push(Act::Time(TimeAct::GoOn(first)));
                }
            }
        });
    });
}

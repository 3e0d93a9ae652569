//! Short messages over the scene: a machine too slow, and what was said last.

use egui::{Align2, Area, FontId, Id, RichText, Ui};

use crate::app::SauteApp;
use crate::layout::Layout;
use crate::theme;

/// Shows the badge and the notice where there is something to say.
pub fn show(app: &SauteApp, ui: &Ui, layout: &Layout) {
    if let Some(behind) = app.session.behind_s() {
        let text = format!("This machine cannot hold {:.0}×: {behind:.0} s behind, none lost", app.session.speed);
        message(ui, layout, "behind", 12.0, &text);
    }
    if let Some(text) = app.notice.current() {
        message(ui, layout, "notice", 52.0, &text);
    }
}

fn message(ui: &Ui, layout: &Layout, name: &str, drop: f32, text: &str) {
    let at = layout.free.center_top() + egui::vec2(0.0, drop);
    Area::new(Id::unique(("message", name))).fixed_pos(at).pivot(Align2::CENTER_TOP).interactable(false).show(
        ui.ctx(),
        |ui| {
            theme::panel().show(ui, |ui| {
                ui.set_max_width(layout.free.width() - 40.0);
                ui.label(RichText::new(text).font(FontId::proportional(14.5)));
            });
        },
    );
}

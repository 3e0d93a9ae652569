//! Short messages over the scene: a machine too slow, and what was said last.

use egui::{Align2, Area, FontId, Id, RichText, Ui};
use saute_kitchen::food::Rules;

use crate::app::SauteApp;
use crate::layout::{GAP, Layout};
use crate::panels::legend;
use crate::theme;
use crate::view::View;

/// Shows the badges and the notice where there is something to say.
pub fn show(app: &SauteApp, ui: &Ui, layout: &Layout) {
    standing(app, ui, layout);
    if let Some(behind) = app.session.behind_s() {
        let text = format!("This machine cannot hold {:.0}×: {behind:.0} s behind, none lost", app.session.speed);
        message(ui, layout, "behind", 12.0, &text);
    }
    if let Some(text) = app.notice.current() {
        message(ui, layout, "notice", 52.0, &text);
    }
}

/// What holds all the time: simplified rules, and the legend of doneness where no panel shows it.
fn standing(app: &SauteApp, ui: &Ui, layout: &Layout) {
    let simple = app.session.kitchen.rules() == Rules::Paper2013;
    let unlabelled = app.settings.view == View::Doneness && (layout.narrow || app.settings.panels_hidden);
    let scale = app.scale().filter(|_| unlabelled);
    if !simple && scale.is_none() {
        return;
    }
    let at = layout.free.left_bottom() + egui::vec2(GAP, -GAP);
    let area = Area::new(Id::unique("standing")).fixed_pos(at).pivot(Align2::LEFT_BOTTOM).interactable(false);
    area.show(ui.ctx(), |ui| {
        theme::panel().inner_margin(8).show(ui, |ui| {
            if let Some(scale) = &scale {
                legend::classes(ui, scale);
            }
            if simple {
                ui.label(RichText::new("rules of 2013").size(15.0).strong().color(theme::ACCENT));
            }
        });
    });
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

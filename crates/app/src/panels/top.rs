//! View chips and the switches of the picture.

use egui::Ui;

use crate::act::{Act, hint};
use crate::app::SauteApp;
use crate::session::STEAK;
use crate::theme;
use crate::view::View;

/// Shows the chips of the views, the switches of cut and split, and what stands at the right.
pub fn show(app: &mut SauteApp, ui: &mut Ui, narrow: bool) {
    if narrow {
        ui.horizontal_wrapped(|ui| views(app, ui, 6.0));
        return;
    }
    ui.horizontal_centered(|ui| {
        views(app, ui, 7.0);
        units_and_help(app, ui);
    });
}

fn views(app: &mut SauteApp, ui: &mut Ui, padding: f32) {
    ui.spacing_mut().item_spacing = egui::vec2(4.0, 5.0);
    ui.spacing_mut().button_padding.x = padding;
    let l = app.settings.language;
    for view in View::ALL {
        chip(app, ui, view.name(l), app.settings.view == view, Act::View(view));
    }
    chip(app, ui, l.text("top.cut"), app.slice.is_some(), Act::Slice);
    chip(app, ui, l.text("top.split"), app.settings.is_split(), Act::Split);
}

/// Shows the unit, the help and, where there is room, the switch of the food's panel, from the right.
pub fn units_and_help(app: &mut SauteApp, ui: &mut Ui) {
    let l = app.settings.language;
    ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
        chip(app, ui, "?", app.help, Act::Help);
        chip(app, ui, app.settings.unit(), false, Act::Units);
        if ui.available_width() > 90.0 {
            let food = l.fill("top.more", &[("what", &food_word(app))]);
            chip(app, ui, &food, app.settings.pantry_open, Act::Pantry);
        }
        if ui.available_width() > 76.0 {
            chip(app, ui, l.text("top.pieces"), app.settings.pieces_open, Act::Pieces);
        }
        // Always in the help as well.
        if ui.available_width() > 68.0 {
            super::language::chip(app, ui);
        }
    });
}

/// The word for what is cooked, where there is room for one only.
pub fn food_word(app: &SauteApp) -> &'static str {
    let key = if app.session.noun() == STEAK { "top.steak" } else { "top.food" };
    app.settings.language.text(key)
}

fn chip(app: &mut SauteApp, ui: &mut Ui, text: &str, on: bool, act: Act) {
    let response = ui.add(theme::of(ui).button(text, on).min_size(egui::vec2(theme::TOUCH, 38.0)));
    let response = response.on_hover_text(hint(act, app.settings.language));
    if response.clicked() {
        app.act(act, &ui.ctx().clone());
    }
}

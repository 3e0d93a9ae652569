//! View chips and the switches of the picture.

use egui::Ui;
use saute_picture::view::View;

use crate::act::{Act, hint};
use crate::app::SauteApp;
use crate::session::STEAK;
use crate::ui::theme;
use crate::words::view_words::ViewWords;

/// Shows the chips of the views, the switches of cut and split, and what stands at the right.
pub fn show(app: &mut SauteApp, ui: &mut Ui, narrow: bool) {
    if narrow {
        ui.horizontal_wrapped(|ui| views(app, ui, 6.0));
        return;
    }
    ui.horizontal_centered(|ui| {
        views(app, ui, 7.0);
        help_and_settings(app, ui);
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

/// Shows the help, the settings and, where there is room, the switches of the panels at the left, from the right.
pub fn help_and_settings(app: &mut SauteApp, ui: &mut Ui) {
    let l = app.settings.language;
    ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
        chip(app, ui, "?", app.help, Act::Help);
        gear(app, ui);
        if ui.available_width() > 90.0 {
            let food = l.fill("top.more", &[("what", &food_word(app))]);
            chip(app, ui, &food, app.settings.pantry_open, Act::Pantry);
        }
        if ui.available_width() > 76.0 {
            chip(app, ui, l.text("top.pieces"), app.settings.pieces_open, Act::Pieces);
        }
    });
}

/// A gear, which needs no language.
fn gear(app: &mut SauteApp, ui: &mut Ui) {
    let name = app.settings.language.text("settings.title");
    let palette = theme::of(ui);
    let response = ui.add(palette.button("", app.settings_open).min_size(egui::vec2(theme::TOUCH, 38.0)));
    response.widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::Button, true, name));
    let ink = if app.settings_open { palette.on_accent } else { palette.text };
    paint_gear(ui.painter(), response.rect.center(), ink);
    if response.on_hover_text(hint(Act::Settings, app.settings.language)).clicked() {
        app.act(Act::Settings, &ui.ctx().clone());
    }
}

/// Eight teeth round a ring.
fn paint_gear(painter: &egui::Painter, at: egui::Pos2, ink: egui::Color32) {
    painter.circle_stroke(at, 5.5, egui::Stroke::new(2.6, ink));
    for tooth in 0..8u8 {
        let along = egui::Vec2::angled(std::f32::consts::TAU * f32::from(tooth) / 8.0);
        painter.line_segment([at + 6.0 * along, at + 9.0 * along], egui::Stroke::new(2.6, ink));
    }
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

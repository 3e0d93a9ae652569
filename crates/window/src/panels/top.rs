//! View chips and the switches of the picture.

use egui::Ui;
use saute_picture::view::View;

use crate::act::{Act, Acts, hint};
use crate::panels::window_state::WindowState;
use crate::session::STEAK;
use crate::ui::theme;
use crate::words::view_words::ViewWords;

/// Shows the chips of the views, the switches of cut and split, and what stands at the right.
pub fn show(state: &WindowState, ui: &mut Ui, acts: &mut Acts, narrow: bool) {
    if narrow {
        ui.horizontal_wrapped(|ui| views(state, ui, acts, 6.0));
        return;
    }
    ui.horizontal_centered(|ui| {
        views(state, ui, acts, 7.0);
        help_and_settings(state, ui, acts);
    });
}

fn views(state: &WindowState, ui: &mut Ui, acts: &mut Acts, padding: f32) {
    ui.spacing_mut().item_spacing = egui::vec2(4.0, 5.0);
    ui.spacing_mut().button_padding.x = padding;
    let l = state.settings.language;
    for view in View::ALL {
        chip(state, ui, acts, view.name(l), state.settings.view == view, Act::View(view));
    }
    chip(state, ui, acts, l.text("top.cut"), state.slice.is_some(), Act::Slice);
    chip(state, ui, acts, l.text("top.split"), state.settings.is_split(), Act::Split);
}

/// Shows the help, the settings and, where there is room, the switches of the panels at the left, from the right.
pub fn help_and_settings(state: &WindowState, ui: &mut Ui, acts: &mut Acts) {
    let l = state.settings.language;
    ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
        chip(state, ui, acts, "?", state.help, Act::Help);
        gear(state, ui, acts);
        if ui.available_width() > 90.0 {
            let food = l.fill("top.more", &[("what", &food_word(state))]);
            chip(state, ui, acts, &food, state.settings.pantry_open, Act::Pantry);
        }
        if ui.available_width() > 76.0 {
            chip(state, ui, acts, l.text("top.pieces"), state.settings.pieces_open, Act::Pieces);
        }
    });
}

/// A gear, which needs no language.
fn gear(state: &WindowState, ui: &mut Ui, acts: &mut Acts) {
    let name = state.settings.language.text("settings.title");
    let palette = theme::of(ui);
    let response = ui.add(palette.button("", state.settings_open).min_size(egui::vec2(theme::TOUCH, 38.0)));
    response.widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::Button, true, name));
    let ink = if state.settings_open { palette.on_accent } else { palette.text };
    paint_gear(ui.painter(), response.rect.center(), ink);
    if response.on_hover_text(hint(&Act::Settings, state.settings.language)).clicked() {
        acts.push(Act::Settings);
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
pub fn food_word(state: &WindowState) -> &'static str {
    let key = if state.session.noun() == STEAK { "top.steak" } else { "top.food" };
    state.settings.language.text(key)
}

fn chip(state: &WindowState, ui: &mut Ui, acts: &mut Acts, text: &str, on: bool, act: Act) {
    let response = ui.add(theme::of(ui).button(text, on).min_size(egui::vec2(theme::TOUCH, 38.0)));
    let response = response.on_hover_text(hint(&act, state.settings.language));
    if response.clicked() {
        acts.push(act);
    }
}

//! View chips and the switches of the picture.

use egui::Ui;
use saute_picture::view::View;

use crate::act::{Act, Acts, hint};
use crate::panels::window_state::WindowState;
use crate::ui::theme;
use crate::words::view_words::ViewWords;

/// Height of a chip [points]: two rows of them fit above a narrow scene.
const HEIGHT: f32 = 34.0;

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
        if ui.available_width() > 40.0 {
            messages(state, ui, acts);
        }
        if ui.available_width() > 90.0 {
            let food = l.fill("top.more", &[("what", &l.text("top.food"))]);
            chip(state, ui, acts, &food, state.settings.pantry_open, Act::Pantry);
        }
        if ui.available_width() > 76.0 {
            chip(state, ui, acts, l.text("top.pieces"), state.settings.pieces_open, Act::Pieces);
        }
    });
}

/// A speech bubble: the list of what was said.
fn messages(state: &WindowState, ui: &mut Ui, acts: &mut Acts) {
    let name = state.settings.language.text("messages.title");
    let palette = theme::of(ui);
    let response = ui.add(palette.button("", state.messages).min_size(egui::vec2(36.0, HEIGHT)));
    response.widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::Button, true, name));
    let ink = if state.messages { palette.on_accent } else { palette.text };
    paint_bubble(ui.painter(), response.rect.center(), ink);
    if response.on_hover_text(hint(&Act::Messages, state.settings.language)).clicked() {
        acts.push(Act::Messages);
    }
}

/// A rounded box with three dots and a tail.
fn paint_bubble(painter: &egui::Painter, at: egui::Pos2, ink: egui::Color32) {
    let body = egui::Rect::from_center_size(at - egui::vec2(0.0, 1.5), egui::vec2(18.0, 12.0));
    painter.rect_stroke(body, 4.0, egui::Stroke::new(1.8, ink), egui::StrokeKind::Middle);
    let tail = [at + egui::vec2(-4.0, 4.5), at + egui::vec2(-5.0, 9.0), at + egui::vec2(1.0, 4.5)];
    painter.add(egui::Shape::convex_polygon(tail.to_vec(), ink, egui::Stroke::NONE));
    for x in [-4.5, 0.0, 4.5] {
        painter.circle_filled(body.center() + egui::vec2(x, 0.0), 1.3, ink);
    }
}

/// A gear, which needs no language.
fn gear(state: &WindowState, ui: &mut Ui, acts: &mut Acts) {
    let name = state.settings.language.text("settings.title");
    let palette = theme::of(ui);
    let response = ui.add(palette.button("", state.settings_open).min_size(egui::vec2(38.0, HEIGHT)));
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

fn chip(state: &WindowState, ui: &mut Ui, acts: &mut Acts, text: &str, on: bool, act: Act) {
    let response = ui.add(theme::of(ui).button(text, on).min_size(egui::vec2(38.0, HEIGHT)));
    let response = response.on_hover_text(explained(state, &act));
    if response.clicked() {
        acts.push(act);
    }
}

/// What a chip does and its key; of a view also what its colours say.
fn explained(state: &WindowState, act: &Act) -> String {
    let hint = hint(act, state.settings.language);
    match act {
        Act::View(view) => format!("{hint}\n{}", view.meaning(state.settings)),
        _ => hint,
    }
}

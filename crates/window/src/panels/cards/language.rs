//! The switch of the window's language.

use egui::Ui;

use crate::act::{Act, Acts, AppAct, Setting};
use crate::panels::window_state::WindowState;
use crate::ui::theme;
use saute_words::language::Language;

/// Shows a chip that bears the other language's own name; where its letters cannot be drawn, its code.
pub fn chip(state: &WindowState, ui: &mut Ui, acts: &mut Acts) {
    let other = state.settings.language.other();
    let name = name(state.japanese_font, other);
    let hint = state.settings.language.fill("top.language", &[("name", &name)]);
    if ui.add(theme::of(ui).button(name, false).min_size(egui::vec2(theme::TOUCH, 38.0))).on_hover_text(hint).clicked()
    {
        acts.push(Act::App(AppAct::Set(Setting::Language(other))));
    }
}

/// A language's own name; where its letters cannot be drawn, its code.
pub fn name(japanese_font: bool, language: Language) -> &'static str {
    match language {
        Language::English => "EN",
        Language::Japanese if japanese_font => "日本語",
        Language::Japanese => "JA",
    }
}

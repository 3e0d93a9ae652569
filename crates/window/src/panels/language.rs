//! The switch of the window's language.

use egui::Ui;

use crate::app::SauteApp;
use crate::ui::theme;
use crate::words::language::Language;

/// Shows a chip that bears the other language's own name; where its letters cannot be drawn, its code.
pub fn chip(app: &mut SauteApp, ui: &mut Ui) {
    let other = app.settings.language.other();
    let name = name(app, other);
    let hint = app.settings.language.fill("top.language", &[("name", &name)]);
    if ui.add(theme::of(ui).button(name, false).min_size(egui::vec2(theme::TOUCH, 38.0))).on_hover_text(hint).clicked()
    {
        app.set_language(other);
    }
}

/// A language's own name; where its letters cannot be drawn, its code.
pub fn name(app: &SauteApp, language: Language) -> &'static str {
    match language {
        Language::English => "EN",
        Language::Japanese if app.japanese_font => "日本語",
        Language::Japanese => "JA",
    }
}

//! The switch of the window's language.

use egui::Ui;

use crate::ui::theme;
use saute_controls::act::{Act, Acts, AppAct, Setting};
use saute_controls::context::PanelContext;
use saute_words::language::{Font, Language};

/// Shows a chip with the next language's own name; where its letters cannot be drawn, its code.
pub fn chip(state: &PanelContext, japanese_font: bool, ui: &mut Ui, acts: &mut Acts) {
    let next = state.settings.language.next();
    let name = name(japanese_font, next);
    let hint = state.settings.language.fill("top.language", &[("name", &name)]);
    if ui.add(theme::of(ui).button(name, false).min_size(egui::vec2(theme::TOUCH, 38.0))).on_hover_text(hint).clicked()
    {
        acts.push(Act::App(AppAct::Set(Setting::Language(next))));
    }
}

/// A language's own name; where its letters cannot be drawn, its code.
pub fn name(japanese_font: bool, language: Language) -> &'static str {
    match language.font() {
        Font::Japanese if !japanese_font => language.short_name(),
        Font::Latin | Font::Japanese => language.name(),
    }
}

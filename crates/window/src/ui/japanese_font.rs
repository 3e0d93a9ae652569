//! The font for Japanese behind that for Latin letters.

use std::sync::Arc;

use egui::{FontData, FontFamily};

use crate::system;

/// The font's name among those of egui.
const NAME: &str = "japanese";

/// Adds the Japanese font behind egui's own, which keep Latin letters and digits; returns true if there is one.
pub fn install(ctx: &egui::Context) -> bool {
    let Some(font) = system::japanese() else {
        ctx.set_fonts(system::latin());
        return false;
    };
    install_font(ctx, font);
    true
}

/// Adds a Japanese font likewise.
pub(crate) fn install_font(ctx: &egui::Context, font: Arc<FontData>) {
    let mut fonts = system::latin();
    fonts.font_data.insert(NAME.to_owned(), font);
    for family in [FontFamily::Proportional, FontFamily::Monospace] {
        fonts.families.entry(family).or_default().push(NAME.to_owned());
    }
    ctx.set_fonts(fonts);
}

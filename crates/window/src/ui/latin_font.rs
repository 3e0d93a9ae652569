//! The font for Latin letters: that of egui.

use egui::FontDefinitions;

/// The fonts of egui.
#[cfg(not(target_arch = "wasm32"))]
pub fn definitions() -> FontDefinitions {
    FontDefinitions::default()
}

/// Of egui's fonts the one that the panels show: the one for code, which only the card of the half mirror shows, would be a
/// twentieth of what a page loads.
#[cfg(target_arch = "wasm32")]
pub fn definitions() -> FontDefinitions {
    const NAME: &str = "Ubuntu-Light";
    let mut fonts = FontDefinitions::empty();
    let font = egui::FontData::from_static(epaint_default_fonts::UBUNTU_LIGHT);
    fonts.font_data.insert(NAME.to_owned(), std::sync::Arc::new(font));
    fonts.families.values_mut().for_each(|family| family.push(NAME.to_owned()));
    fonts
}

//! Fonts of a page.

use std::sync::Arc;

use egui::{FontData, FontDefinitions};

/// Of egui's fonts the one that the panels show: the one for code, which only the card of the half mirror shows, would be a
/// twentieth of what a page loads.
pub(crate) fn latin() -> FontDefinitions {
    const NAME: &str = "Ubuntu-Light";
    let mut fonts = FontDefinitions::empty();
    let font = FontData::from_static(epaint_default_fonts::UBUNTU_LIGHT);
    fonts.font_data.insert(NAME.to_owned(), Arc::new(font));
    fonts.families.values_mut().for_each(|family| family.push(NAME.to_owned()));
    fonts
}

/// A page has no fonts of the system, and none in itself: few visitors need one.
pub(crate) fn japanese() -> Option<Arc<FontData>> {
    None
}

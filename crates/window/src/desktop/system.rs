//! Properties of the system and of the person at it.

use saute_words::language::Language;

pub(crate) use saute_controls::kept::time_of_day::time_of_day;

/// Name of the program, after which eframe names the folder of its settings.
pub(crate) const NAME: &str = "saute";

/// The window is no page.
pub(crate) const IS_PAGE: bool = false;

/// The language of the environment.
pub(crate) fn language() -> Language {
    Language::of_environment()
}

/// A window has no address.
pub(crate) fn page_address() -> Option<String> {
    None
}

/// Media queries have results in pages only.
pub(crate) fn asks(_: &str) -> bool {
    false
}

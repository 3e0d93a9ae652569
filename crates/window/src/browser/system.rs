//! Properties of the browser and of the person at it.

use saute_words::language::Language;

/// The window is a page.
pub(crate) const IS_PAGE: bool = true;

/// The language that the browser prefers.
pub(crate) fn language() -> Language {
    let preferred = web_sys::window().and_then(|window| window.navigator().language());
    preferred.map_or_else(Language::default, |tag| Language::of_locale(&tag))
}

/// The time of day [ISO 8601, UTC].
pub(crate) fn time_of_day() -> String {
    js_sys::Date::new_0().to_iso_string().into()
}

/// The address of the page without its query and fragment.
pub(crate) fn page_address() -> Option<String> {
    let address = web_sys::window()?.location().href().ok()?;
    address.split(['?', '#']).next().map(str::to_owned)
}

/// Returns the browser's result of a media query.
pub(crate) fn asks(query: &str) -> bool {
    let asked = web_sys::window().and_then(|window| window.match_media(query).ok().flatten());
    asked.is_some_and(|answer| answer.matches())
}

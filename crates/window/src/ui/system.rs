//! What the system says about the person at it: the language, and in browsers the pointer and the wish for less motion.

use saute_words::language::Language;

/// Returns the language that the browser prefers, or that of the environment.
pub(crate) fn language() -> Language {
    #[cfg(target_arch = "wasm32")]
    return crate::browser::language().map_or_else(Language::default, |tag| Language::of_locale(&tag));
    #[cfg(not(target_arch = "wasm32"))]
    Language::of_environment()
}

/// Returns true if the main pointer is a finger.
pub(crate) fn has_coarse_pointer() -> bool {
    says("(pointer: coarse)")
}

/// Returns true if the person has asked for less motion.
pub(crate) fn wants_less_motion() -> bool {
    says("(prefers-reduced-motion: reduce)")
}

#[cfg(target_arch = "wasm32")]
fn says(query: &str) -> bool {
    let asked = web_sys::window().and_then(|window| window.match_media(query).ok().flatten());
    asked.is_some_and(|answer| answer.matches())
}

#[cfg(not(target_arch = "wasm32"))]
fn says(_: &str) -> bool {
    false
}

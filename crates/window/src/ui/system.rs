//! What the system says about the person at it; only browsers say it.

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

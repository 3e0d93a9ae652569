//! Properties of the system and of the person at it: the language, the time of day, fonts, and in browsers the
//! address, the pointer and the wish for less motion.

#[cfg(target_arch = "wasm32")]
use crate::browser::{fonts, system as current};
#[cfg(not(target_arch = "wasm32"))]
use crate::desktop::{fonts, system as current};
pub(crate) use current::{IS_PAGE, language, page_address, time_of_day};
pub(crate) use fonts::{japanese, latin};

/// Returns true if the main pointer is a finger.
pub(crate) fn has_coarse_pointer() -> bool {
    current::asks("(pointer: coarse)")
}

/// Returns true if the person has asked for less motion.
pub(crate) fn wants_less_motion() -> bool {
    current::asks("(prefers-reduced-motion: reduce)")
}

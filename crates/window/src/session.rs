//! The session with the hands that the window has.

#[cfg(target_arch = "wasm32")]
use crate::browser::hands::Hands;
#[cfg(not(target_arch = "wasm32"))]
use crate::desktop::hand::Hands;

/// A cook that goes on in the window.
pub type Session = saute_session::Session<Hands>;

//! What panels show that only a desktop, or only a page, has.

#[cfg(target_arch = "wasm32")]
pub(crate) use crate::browser::panels::*;
#[cfg(not(target_arch = "wasm32"))]
pub(crate) use crate::desktop::panels::*;

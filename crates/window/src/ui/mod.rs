//! Theme, layout and the scene's part of the window.

pub(crate) mod aloud;
pub mod bell;
pub mod fingers;
pub mod glance;
pub mod interface_size;
pub(crate) mod japanese_font;
pub(crate) mod latin_font;
pub mod layout;
pub mod motion;
pub mod notice;
pub mod palette;
pub mod quality_choice;
pub mod scene_view;
#[cfg(not(target_arch = "wasm32"))]
pub mod stored_zoom;
pub(crate) mod system;
pub(crate) mod tab_end;
pub mod theme;
pub mod ways_layout;
pub(crate) mod ways_view;

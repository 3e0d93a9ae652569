//! Theme, layout and the scene's part of the window.

pub(crate) mod aloud;
pub mod bell;
pub mod fingers;
pub mod glance;
pub mod interface_size;
pub(crate) mod japanese_font;
pub mod layout;
pub mod motion;
pub mod notice;
pub mod palette;
pub mod quality_choice;
pub mod scene_view;
pub(crate) mod tab_end;
pub mod theme;
pub mod ways_layout;
pub(crate) mod ways_view;

//! Theme, layout and the scene's part of the window.

pub(crate) mod aloud;
pub mod bell;
pub mod display;
pub mod fingers;
pub(crate) mod japanese_font;
pub mod layout;
pub mod loudspeaker;
pub mod palette;
pub(crate) mod picking;
pub mod scene_view;
pub(crate) mod tab_end;
pub mod theme;
pub mod ways_layout;
pub(crate) mod ways_view;

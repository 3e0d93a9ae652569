//! The window of the frying-pan simulator: panels, the scene below them, the half mirror, and what a desktop or a page does for them.
//!
//! [`SauteApp`] owns the state. Panels read a [`saute_controls::context::PanelContext`], or their own state that derefs to it, and return
//! [`saute_controls::act::Act`]s; keys and gamepads give acts too. [`SauteApp::act`] alone carries them out.

pub mod app;
pub mod bindings;
#[cfg(target_arch = "wasm32")]
pub mod browser;
#[cfg(not(target_arch = "wasm32"))]
pub mod desktop;
pub mod host;
pub mod learn;
pub mod listener;
pub mod mirror;
pub mod paint;
pub mod panels;
pub mod start;
pub(crate) mod system;
pub mod ui;

pub use app::SauteApp;
pub use start::{DesktopOptions, Start, StartError};

//! The window of the frying-pan simulator: session, panels, input, haptic hands and the half mirror.
//!
//! [`SauteApp`] owns the state. Panels read a [`panels::context::PanelContext`], or a state of their own that derefs to it, and return
//! [`act::Act`]s; keys and gamepads give acts too. [`SauteApp::act`] alone carries them out.
//!
//! ```
//! use saute_window::settings::Settings;
//!
//! let celsius = Settings::default();
//! let fahrenheit = Settings { fahrenheit: true, ..Settings::default() };
//! // Core temperature of a medium steak, as the panels write it.
//! assert_eq!(celsius.temperature(60.0), "60\u{a0}°C");
//! assert_eq!(fahrenheit.temperature(60.0), "140\u{a0}°F");
//! ```

pub mod act;
pub mod app;
pub mod at_home;
#[cfg(target_arch = "wasm32")]
pub mod browser;
pub mod controls;
#[cfg(not(target_arch = "wasm32"))]
pub mod desktop;
pub mod frame_meter;
pub mod governor;
pub mod host;
pub mod input;
pub mod learn;
pub mod listener;
pub mod mirror;
pub mod paint;
pub mod panels;
pub mod plan;
pub mod pose;
mod remembered;
pub mod session;
pub mod settings;
pub mod spoken;
pub mod start;
pub(crate) mod system;
pub mod ui;

pub use app::SauteApp;
pub use start::{DesktopOptions, Start, StartError};

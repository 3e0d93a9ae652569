//! The window of the frying-pan simulator: session, panels, input, haptic hands and the half mirror.
//!
//! [`SauteApp`] owns the state. Panels read it as a [`panels::window_state::WindowState`] and return [`act::Act`]s;
//! keys and gamepads give acts too. [`SauteApp::act`] alone carries them out.
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
#[cfg(not(target_arch = "wasm32"))]
pub mod bench_frame;
#[cfg(target_arch = "wasm32")]
pub mod browser;
pub mod controls;
#[cfg(not(target_arch = "wasm32"))]
mod desktop;
pub mod frame_meter;
pub mod governor;
pub mod guided;
#[cfg(not(target_arch = "wasm32"))]
pub mod hand;
pub mod input;
pub mod kept;
pub mod learn;
pub mod listener;
pub mod mirror;
#[cfg(not(target_arch = "wasm32"))]
pub mod offscreen;
pub mod paint;
pub mod panels;
#[cfg(not(target_arch = "wasm32"))]
pub mod photo;
pub mod plan;
pub mod pose;
pub mod session;
pub mod settings;
pub mod spoken;
pub mod start;
pub mod ui;
#[cfg(not(target_arch = "wasm32"))]
pub mod window;

pub use app::SauteApp;
pub use start::{Start, StartError};

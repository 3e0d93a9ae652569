//! What a person at the window can do, has set, holds and is told. Nothing here draws, and nothing depends on egui.
//!
//! [`act::Act`] is one thing to do; keys, panels, gamepads and the Now line give acts, and the window carries them out.
//! [`settings::Settings`] are remembered from one start to the next. [`context::PanelContext`] is what every panel reads.
//!
//! ```
//! use saute_controls::settings::Settings;
//!
//! let celsius = Settings::default();
//! let fahrenheit = Settings { fahrenheit: true, ..Settings::default() };
//! // Core temperature of a medium steak, as the panels write it.
//! assert_eq!(celsius.temperature(60.0), "60\u{a0}°C");
//! assert_eq!(fahrenheit.temperature(60.0), "140\u{a0}°F");
//! ```

pub mod act;
pub mod ahead_words;
pub mod at_home;
pub mod context;
pub mod control_list;
pub mod eye;
pub mod goal_choice;
pub mod hands;
pub mod input;
#[cfg(not(target_arch = "wasm32"))]
pub mod kept;
pub mod learning;
pub mod now;
pub mod plan;
pub mod pose;
pub mod session;
pub mod settings;
pub mod spoken;
pub mod tutorial;
pub mod ways_state;

//! The window: session, panels, input, the half mirror and hands.

pub mod act;
pub mod app;
#[cfg(not(target_arch = "wasm32"))]
pub mod bench_frame;
pub mod governor;
#[cfg(not(target_arch = "wasm32"))]
pub mod hand;
pub mod input;
pub mod mirror;
#[cfg(not(target_arch = "wasm32"))]
pub mod offscreen;
pub mod paint;
pub mod panels;
mod remembered;
pub mod session;
pub mod settings;
pub mod ui;
#[cfg(not(target_arch = "wasm32"))]
pub mod window;
pub mod words;

pub use app::{SauteApp, Start, StartError};
pub use words::language::Language;
pub use words::view_words::ViewWords;

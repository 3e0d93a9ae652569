//! The window of saute: renderer, panels, input.

pub mod act;
pub mod app;
#[cfg(not(target_arch = "wasm32"))]
pub mod bench_frame;
mod cell_look;
pub mod colour_map;
pub mod colour_path;
pub mod food_look;
mod grab;
pub mod hatch;
#[cfg(not(target_arch = "wasm32"))]
pub mod headless;
pub mod layout;
pub mod motion;
pub mod notice;
#[cfg(not(target_arch = "wasm32"))]
pub mod offscreen;
mod pan_keys;
pub mod panels;
mod picking;
mod piece_words;
pub mod png_file;
pub mod probe;
mod probe_hand;
mod put_in;
mod save_picture;
mod scale_choice;
pub mod scene;
pub mod scene_view;
pub mod section_picture;
pub mod seen_point;
pub mod session;
pub mod settings;
#[cfg(not(target_arch = "wasm32"))]
pub mod shot;
mod split;
pub mod stage;
pub mod theme;
pub mod view;
pub mod waiting;
#[cfg(not(target_arch = "wasm32"))]
pub mod window;

pub use app::{SauteApp, Start, StartError};
pub use colour_map::TemperatureMap;
pub use section_picture::{Picture, section_picture};
pub use view::View;

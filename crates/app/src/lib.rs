//! The window of saute: renderer, panels, input.

pub mod act;
pub mod app;
#[cfg(not(target_arch = "wasm32"))]
pub mod bench_frame;
mod cell_look;
pub mod colour_map;
pub mod colour_path;
mod cut_face;
mod cut_rim;
mod flesh_grain;
pub mod food_look;
pub mod gamepad;
#[cfg(not(target_arch = "wasm32"))]
mod gamepad_device;
pub mod governor;
mod grab;
mod halves;
#[cfg(not(target_arch = "wasm32"))]
pub mod hand;
pub mod hatch;
#[cfg(not(target_arch = "wasm32"))]
pub mod headless;
pub mod interface_size;
mod japanese_font;
pub mod language;
pub mod layout;
pub mod mirror;
pub mod motion;
mod next_step;
pub mod notice;
#[cfg(not(target_arch = "wasm32"))]
pub mod offscreen;
mod pad_input;
pub mod palette;
mod pan_film;
mod pan_keys;
mod pan_tint;
pub mod panels;
mod path_cut;
mod picking;
mod piece_words;
pub mod png_file;
pub mod pouring;
pub mod probe;
mod probe_hand;
mod put_in;
pub mod quality_choice;
pub mod refusal;
mod remembered;
mod save_picture;
mod scale_choice;
pub mod scene;
pub mod scene_view;
pub mod section_picture;
#[cfg(not(target_arch = "wasm32"))]
pub mod seen_colour;
pub mod seen_point;
pub mod session;
pub mod settings;
#[cfg(not(target_arch = "wasm32"))]
pub mod shot;
mod spatter_look;
mod split;
pub mod stage;
pub mod theme;
mod tool_hand;
pub mod view;
pub mod waiting;
#[cfg(not(target_arch = "wasm32"))]
pub mod window;

pub use app::{SauteApp, Start, StartError};
pub use colour_map::TemperatureMap;
pub use language::Language;
pub use section_picture::{Picture, section_picture};
pub use view::View;

//! Pictures of a kitchen: its state as the renderer's input, colour maps, cuts, sections and stills.
//!
//! [`stage::Stage`] turns a kitchen into a [`saute_scene::input::SceneInput`]. The crate computes no physics and opens
//! no window.

pub mod colour;
pub mod cut;
mod pan;
pub mod probe;
pub mod seen_point;
pub mod skin;
pub mod split;
pub mod stage;
pub mod still;
pub mod view;
pub mod waiting;

pub use colour::map::TemperatureMap;
pub use cut::section::{Picture, section_picture};
pub use view::View;

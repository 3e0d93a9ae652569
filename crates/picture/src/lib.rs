//! Pictures of a kitchen: its state as the renderer's input, colour maps, cuts, sections and stills.
//!
//! [`stage::Stage`] turns a kitchen into a [`saute_scene::input::SceneInput`]. The crate computes no physics and opens
//! no window.
//!
//! Colours of a field can be decoded again, so that a picture is a measurement:
//!
//! ```
//! use saute_picture::TemperatureMap;
//!
//! let map = TemperatureMap::Uniform.map();
//! let colour = map.colour(63.4);
//! // The temperature of a colour [°C], and its distance from the map in 8-bit units.
//! let (celsius, distance) = map.decode(colour);
//! assert!((celsius - 63.4).abs() < 1.0 && distance < 2.0);
//! ```

pub mod colour;
pub mod cut;
mod pan;
pub mod pose;
pub mod probe;
pub mod seen_point;
pub mod skin;
pub mod split;
pub mod stage;
pub mod still;
mod vapour;
pub mod view;
pub mod waiting;

pub use colour::map::TemperatureMap;
pub use cut::section::{Picture, section_picture};
pub use view::View;

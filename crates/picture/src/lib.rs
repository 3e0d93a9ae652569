//! Pictures of a kitchen: its state as the renderer's input, colour maps, cuts, sections and stills,
//! also through a half mirror, and the quality that a machine holds.
//!
//! [`stage::Stage`] turns a kitchen into a [`saute_scene::input::SceneInput`]. The crate computes no physics and opens
//! no window.
//!
//! Each vertex of a food carries the state of its node (browning, charring, wetness, cooked share, coordinate of the
//! field) and the `L*a*b*` colours of lean flesh and fat before browning. Variation finer than the mesh (fat seams,
//! second tissues, borders of sheaths) comes as a small volume. A cut face ends on the surface as drawn. What browned
//! on ridges is on their lines, with the mean of the face unchanged. The contents of the pan are a picture of 64 ×
//! 64 texels of its floor: oil, water, fond, foam. A point under the pointer is a list of node weights, so a probe
//! stays in the flesh as it contracts. Split view draws one scene twice.
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
pub mod frame_meter;
pub mod governor;
pub mod mirrored;
pub mod motion;
mod pace;
pub mod painted;
mod pan;
pub mod plated;
pub mod pose;
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

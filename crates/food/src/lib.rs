//! What heat does to food: properties, water, proteins, browning and colour.
//!
//! A [`FoodModel`] is what never changes after it is built (rest mesh, composition, tables of rates); a
//! [`FoodState`] is what does. [`FoodSolver::advance`] moves a state through one tick between given surroundings.

pub mod advance;
pub mod air_film;
pub mod body;
pub mod browning;
mod cell_body;
pub mod changes;
pub mod colour;
pub mod components;
pub mod description;
pub mod doneness;
pub mod fat;
mod films;
pub mod form;
pub mod halving;
pub mod juice;
mod juice_way;
pub mod limp;
pub mod marbling;
pub mod marbling_volume;
pub mod model;
mod node_means;
pub mod noise;
pub mod paper_2013;
pub mod patch;
pub mod present_shape;
pub mod readings;
pub mod rounded;
pub mod shrimp;
pub mod shrink;
pub mod solid;
pub mod sorption;
pub mod state;
pub mod surface;
pub mod table;
pub mod tissue;
pub mod water;

pub use advance::{Exchange, FoodSolver, Surroundings, Touch, present_area};
pub use air_film::FreeAir;
pub use body::Body;
pub use colour::Lab;
pub use description::{FoodDescription, Kinetics};
pub use doneness::{Scale, Shares};
pub use form::Form;
pub use model::{BuildError, FoodModel, PieceSpec};
pub use paper_2013::{MeshSize, Rules};
pub use patch::{Face, Patch};
pub use solid::{Capsule, Solid};
pub use state::FoodState;
pub use surface::{PatchGeometry, PatchPose};

/// Absolute temperature of 0 °C [K].
pub const ZERO_C: f64 = 273.15;

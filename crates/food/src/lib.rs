//! What heat does to food: properties, water, proteins, browning and colour.
//!
//! A [`FoodModel`] is what never changes after it is built (rest mesh, composition, tables of rates); a
//! [`FoodState`] is what does. [`FoodSolver::advance`] moves a state through one tick between given surroundings.

pub mod advance;
pub mod body;
mod build_error;
pub mod change;
pub mod components;
pub mod description;
pub mod model;
pub mod paper_2013;
pub mod readings;
pub mod state;
pub mod table;
pub mod tissue;
pub mod water;

pub use body::{form, halving, limp, patch, present_shape, rounded, shrimp, shrink, solid, surface};
pub use change::{browning, changes, colour, doneness};
pub use tissue::{marbling, marbling_volume, noise};
pub use water::{air_film, fat, juice, sorption};

pub use advance::{Exchange, FoodSolver, Surroundings, Touch, present_area};
pub use body::{Body, Capsule, Face, Form, Patch, PatchGeometry, PatchPose, Solid};
pub use change::{Lab, Scale, Shares};
pub use description::{FoodDescription, Kinetics};
pub use model::{BuildError, FoodModel, PieceSpec};
pub use paper_2013::{MeshSize, Rules};
pub use state::FoodState;
pub use water::FreeAir;

/// Absolute temperature of 0 °C [K].
pub const ZERO_C: f64 = 273.15;

/// Standard acceleration of gravity [m/s²] (3rd General Conference on Weights and Measures, CGPM 1901).
pub const GRAVITY: f64 = 9.806_65;

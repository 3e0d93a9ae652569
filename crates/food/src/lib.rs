//! Heat transfer and cooking of a piece of food: temperature, water, proteins, browning, shrinkage and colour.
//!
//! A [`FoodModel`] contains everything that heating does not change: rest mesh, composition and tables of rates. A
//! [`FoodState`] contains everything that it changes. [`FoodSolver::advance`] advances a state by one tick with given
//! [`Surroundings`]. The crate is a pure function of model, state, surroundings and time step: it reads no clock and no
//! files.
//!
//! A coin of gel, 60 mm across and 10 mm thick, lies from 5 °C in a water bath of 60 °C:
//!
//! ```
//! use saute_food::components::Components;
//! use saute_food::{
//!     FoodDescription, FoodModel, FoodSolver, FoodState, FreeAir, Kinetics, MeshSize, OutlineKind, PieceSpec, Rules, Surroundings,
//!     Touch, ZERO_C,
//! };
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let food: FoodDescription = toml::from_str(include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/doc/gel.toml")))?;
//! let kinetics: Kinetics =
//!     toml::from_str(include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/doc/gel-kinetics.toml")))?;
//! let components: Components =
//!     toml::from_str(include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/doc/constant-components.toml")))?;
//!
//! let piece = PieceSpec {
//!     size: [0.060, 0.060, 0.010], // length, width, thickness [m]
//!     seed: 1,
//!     coarseness: 2.0, // twice the default spacing: fewer nodes
//!     mesh: MeshSize::Default,
//!     rules: Rules::Full,
//!     outline: OutlineKind::Plain,
//!     pool: None,
//! };
//! let model = FoodModel::build(&food, &kinetics, &components, &piece)?;
//! let mut state = FoodState::raw(&model, ZERO_C + 5.0);
//!
//! // Every patch touches water: 1000 W/(m²·K) at 60 °C. Without a free patch the air does not matter.
//! let touch = vec![Touch::Contact { conductance: 1000.0, temperature: ZERO_C + 60.0 }; model.patches().len()];
//! let air = FreeAir {
//!     temperature: ZERO_C + 20.0,
//!     walls: ZERO_C + 20.0,
//!     convection: 7.0,
//!     radiation: 1.0,
//!     vapour_density: 0.01,
//!     mass_transfer: 4.0e-3,
//! };
//! let around = Surroundings { touch: &touch, air: &[air; 3], pressed: 0.0 };
//!
//! let mut solver = FoodSolver::default();
//! let before = state.total_enthalpy();
//! let mut gained = 0.0;
//! for _ in 0..6000 {
//!     solver.advance(&model, &mut state, &around, 0.1); // a tick of 0.1 s
//!     gained += solver.contact_heat.iter().sum::<f64>();
//! }
//!
//! // After ten minutes the core is within 1 K of the bath [°C].
//! let core = model.core_temperature(&state) - ZERO_C;
//! assert!((59.0..60.1).contains(&core), "{core} °C");
//! // The heat from the bath is in the gel [J].
//! assert!((state.total_enthalpy() - before - gained).abs() < 1e-6 * gained);
//! # Ok(())
//! # }
//! ```
//!
//! Modules: [`body`] contains mesh, faces and shape, [`tissue`] marbling and other variation, [`change`] kinetics, browning,
//! doneness and colour, [`water`] everything that leaves a piece, [`description`] the tables of the data files, [`reduced`] a slice on a coarse
//! mesh.

pub mod advance;
pub mod body;
mod build_error;
pub mod change;
pub mod components;
pub mod description;
mod individual;
pub mod model;
pub mod node_fields;
pub mod paper_2013;
mod piece_spec;
pub mod readings;
pub mod reduced;
pub mod state;
pub mod table;
pub mod tissue;
pub mod touch;
pub mod water;

pub use advance::{Exchange, FoodSolver, Surroundings, present_area};
pub use body::{Body, Capsule, Face, Form, Patch, PatchGeometry, PatchPose, Solid};
pub use build_error::BuildError;
pub use change::{Lab, Scale, Shares};
pub use description::{FoodDescription, Kinetics, OutlineKind};
pub use model::FoodModel;
pub use node_fields::NodeField;
pub use paper_2013::{MeshSize, Rules};
pub use piece_spec::PieceSpec;
pub use reduced::Reduction;
pub use state::FoodState;
pub use touch::Touch;
pub use water::FreeAir;

/// Absolute temperature of 0 °C [K].
pub const ZERO_C: f64 = 273.15;

/// Standard acceleration of gravity [m/s²] (3rd General Conference on Weights and Measures, CGPM 1901).
pub const GRAVITY: f64 = 9.806_65;

//! Water, vapour and fat that leave a piece: sorption, water holding, juice, rendering and evaporation.
//!
//! Water: flesh binds less water as it heats, by a curve of temperature or by its changed proteins, whichever binds
//! less. The difference is released with a first-order lag, flows along the fibres at some tens of µm/s, is absorbed by
//! dried tissue on its way, passes boiling flesh as liquid in part, gathers as a film and runs off. A node boils at the temperature at which the vapour
//! pressure of its moisture reaches one atmosphere (GAB isotherm), so a wet surface stays at 100 °C and a crust keeps
//! a residual moisture.

pub mod air_film;
mod early_steam;
pub mod fat;
pub(crate) mod films;
pub mod ice;
pub mod juice;
mod juice_flow;
mod juice_way;
mod raw_film;
pub mod sorption;
mod squeezed;
mod transport;
pub mod vapour;

pub use air_film::FreeAir;
pub use juice::Runoff;
pub use vapour::{ATMOSPHERE, VAPOUR_GAS_CONSTANT, latent_heat, saturation_density, saturation_pressure};

pub(crate) use transport::WaterTransport;

//! Water, vapour and fat that leave a piece: sorption, water holding, juice, rendering and evaporation.

pub mod air_film;
pub mod fat;
pub mod juice;
mod juice_way;
pub mod sorption;
mod transport;
pub mod vapour;

pub use air_film::FreeAir;
pub use juice::Runoff;
pub use vapour::{ATMOSPHERE, VAPOUR_GAS_CONSTANT, latent_heat, saturation_density, saturation_pressure};

pub(crate) use transport::WaterTransport;

//! Oil, water, butter and fond on the pan, and what leaves them as spatter and smoke.

pub mod butter;
pub mod drop_flight;
pub mod film_flow;
pub mod fond;
pub mod liquid_layer;
pub mod oil;
pub mod oil_film;
pub mod smoke;
pub mod solids_rates;
pub mod spatter;
pub mod water_film;

pub use liquid_layer::{Around, LiquidModel, LiquidSolver, Liquids};

//! The pan on its hob: metal, glass, cloth, lid, and what foods see of its surface.

pub mod bed;
pub mod cloth;
pub(crate) mod fond_seen;
pub(crate) mod food_load;
pub mod heat_tint;
pub mod heater;
pub mod hob;
pub mod hold;
pub mod lid;
pub(crate) mod near_pan;
pub(crate) mod observed_pan;
pub(crate) mod pan_class;
pub mod pan_description;
pub mod pan_model;
pub mod ridges;
pub mod under;

pub use pan_model::{LEVEL, PanExchange, PanLoad, PanModel, PanSolver, PanState};

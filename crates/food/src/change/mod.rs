//! Irreversible changes of heated food: first-order kinetics, browning, doneness and colour.

pub mod browning;
pub mod changes;
pub mod colour;
pub mod doneness;
pub(crate) mod response;

pub use browning::Browning;
pub use changes::ChangeRates;
pub use colour::{Appearance, Lab, Palette};
pub use doneness::{Scale, Shares};

//! Irreversible changes of heated food: first-order kinetics, browning, doneness and colour.
//!
//! The changes of a food are the entries of its kinetics file; colours, stiffness, hardness, juiciness, water holding
//! and contraction refer to them by name. `Rules::Paper2013` builds the same model with the rules of the 2013
//! simulator `[@kato-hasegawa-2013]`.

pub mod browning;
pub mod changes;
pub mod colour;
pub mod doneness;
pub mod inside_of_beef;
pub(crate) mod response;

pub use browning::Browning;
pub use changes::ChangeRates;
pub use colour::{Appearance, Lab, Palette};
pub use doneness::{Scale, Shares};

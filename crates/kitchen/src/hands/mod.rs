//! Commands, their execution, tools that a person moves freely, and the load on the hand that holds the pan.

pub mod command;
mod knife;
pub(crate) mod lead;
mod orders;
pub(crate) mod pan_hold;
mod pan_wrench;
mod pour;
pub mod ranges;
pub(crate) mod second_hand;
mod wipe;

pub use pan_wrench::{FoodVelocities, PanWrench};

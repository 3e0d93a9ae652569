//! Commands, their execution, and tools that a person moves freely.

pub mod command;
mod knife;
pub(crate) mod lead;
mod orders;
pub(crate) mod pan_hold;
mod pour;
pub(crate) mod second_hand;

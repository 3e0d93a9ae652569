//! Commands, their execution, and tools that a person moves freely.

pub mod command;
mod knife;
pub(crate) mod lead;
mod orders;
mod pour;

//! What hands do: commands, what carries them out, and the tool that a person leads.

pub mod command;
mod knife;
pub(crate) mod lead;
mod orders;
mod pour;

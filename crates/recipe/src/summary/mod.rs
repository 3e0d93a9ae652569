//! What a cook came to, as JSON has it.

pub mod cook_summary;
pub mod group_summary;

pub use cook_summary::*;

//! The result of a cook, as JSON shows it.

pub mod cook_summary;
pub mod group_summary;

pub use cook_summary::*;

//! Surfaces of foods: vertices with a state, grain, and halves.

pub(crate) mod cells;
pub(crate) mod grain;
pub(crate) mod halves;
pub mod surface;

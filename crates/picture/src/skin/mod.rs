//! Surfaces of foods: vertices with a state, grain, and halves.

pub(crate) mod cells;
pub(crate) mod fine;
pub(crate) mod grain;
pub(crate) mod halves;
pub(crate) mod pool;
pub(crate) mod poured;
pub(crate) mod rim;
pub(crate) mod sheaths;
mod side;
pub mod surface;

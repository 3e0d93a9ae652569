//! Colours of values: tables, maps, and the patterns of classes.

pub mod hatch;
pub mod map;
pub mod path;
pub mod side_by_side;

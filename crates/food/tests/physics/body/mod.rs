//! Tests of the bodies: forms, cells, halves and shrinkage.

pub mod cells;
mod forms;
mod halving;
mod natural;
mod poured;
mod shrinking;

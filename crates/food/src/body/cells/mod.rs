//! Bodies of cells inside a closed surface: how they are meshed, and their shape as they contract.

pub(crate) mod cell_body;
mod cell_change;

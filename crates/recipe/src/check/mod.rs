//! Checks of a recipe file: what parses must also be possible.

mod action_check;
pub(crate) mod recipe_check;
pub(crate) mod sequence_check;

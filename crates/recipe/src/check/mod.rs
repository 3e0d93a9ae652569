//! Checks of a recipe file: what parses must also be possible.

mod action_check;
mod condition_check;
pub(crate) mod recipe_check;
mod repeat_check;
mod room_check;
pub(crate) mod sequence_check;

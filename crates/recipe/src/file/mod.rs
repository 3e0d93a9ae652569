//! The format of a recipe file, before its checks.

pub mod action_file;
pub mod recipe_file;
pub mod repeat_file;
pub mod shorthand;
pub mod step_file;

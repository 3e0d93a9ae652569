//! The recipe file as it is written, and errors that name file, line, key and remedy.

pub mod action_file;
pub mod recipe_file;
pub mod shorthand;
pub mod step_file;

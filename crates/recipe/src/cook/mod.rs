//! The execution of a recipe: runner, recorder, and both with their kitchen.

mod crossing;
pub mod play;
pub mod recorder;
pub mod runner;
pub mod step_record;

//! The execution of a recipe: runner, recorder, and both with their kitchen.

pub mod play;
pub mod recorder;
mod repeating;
pub mod runner;
pub mod runner_state;
pub mod step_record;
mod watch;

//! A recipe as it is played: runner, recorder, and both with their kitchen.

pub mod play;
pub mod recorder;
pub mod runner;
pub mod step_record;
mod watch;

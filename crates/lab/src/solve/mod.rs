//! Runs a case: conduction by the method of lines on a product mesh, or the full food model.

pub mod body;
mod cooking;
mod cooking_body;
mod edge_system;
pub mod material;
mod run;
pub mod solver;
pub mod watch;
pub mod work;

pub use run::{run, run_watched};

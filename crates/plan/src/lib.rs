//! Planning with the simulator: it hands out jobs, and the program around it runs them.
//!
//! [`goal`] states what a cook is to give and scores what it gave. [`schedule`] searches for the times and powers that
//! meet a goal best. [`forecast`] states what comes of the present state of a cook. [`fit`] finds what a kitchen at home has
//! otherwise, from what was measured there. This crate starts no thread, opens no file and reads no clock; a shell runs the
//! jobs of a round in any order, on as many threads as it likes: the answer is the same.

mod aimed;
pub mod fit;
pub mod forecast;
pub mod goal;
mod round;
pub mod schedule;

pub use aimed::Aimed;
pub use round::{End, Shared};

//! Planning with the simulator: it hands out jobs, and the program around it runs them.
//!
//! [`goal`] states what a cook is wanted to give and scores what it gave. [`schedule`] searches for the times and powers that
//! meet a goal best.

pub mod goal;
pub mod schedule;

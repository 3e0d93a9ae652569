//! What the folder of a sweep promises, in one program: one is linked sooner than many.

// A test that fails at an unwrap names its line.
#![allow(clippy::unwrap_used)]

mod folder;
mod tally;
mod throughput;

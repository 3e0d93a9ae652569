//! What all readers promise under attack, in one program: one is linked sooner than many.

// A test that fails at an unwrap names its line.
#![allow(clippy::unwrap_used)]

mod doors;
mod hostile_numbers;
mod mutations;
mod replay;

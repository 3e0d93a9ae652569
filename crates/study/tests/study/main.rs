//! What studies and lessons promise, without a window.

// A test that fails at an unwrap names its line.
#![allow(clippy::unwrap_used)]

mod analysis;
mod intervals;
mod lessons;
mod pace;
mod protocols;
mod way;

//! The command as its users see it: what it prints, writes, refuses, and how it exits.

// A test that fails at an unwrap names its line.
#![allow(clippy::unwrap_used)]

mod architecture;
mod cook;
mod haptics;
mod layers;
mod library;
mod pictures;
mod running;
mod sources;
mod validation;

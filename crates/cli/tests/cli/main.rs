//! The command from outside: output, files, refusals and exit codes.

// A test that fails at an unwrap names its line.
#![allow(clippy::unwrap_used)]

mod architecture;
mod cook;
mod cycles;
mod dependencies;
mod faults;
mod fit;
mod folders;
mod haptics;
#[cfg(target_os = "linux")]
mod killed;
mod layers;
mod library;
mod manual;
mod pictures;
mod plan;
mod running;
mod sessions;
mod sources;
mod study;
mod sweep;
mod validation;
mod validation_list;

//! What the simulated device promises, driven in memory on a virtual clock: by the driver of `saute`, and by hostile hosts.

// A failed unwrap in a test names its line.
#![allow(clippy::unwrap_used)]

mod hostile_host;
mod memory_link;
mod normal_use;
mod open_questions;

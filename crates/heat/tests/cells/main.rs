//! Closed surfaces and the cells inside them: defects, conservation, and accuracy.

// A failed unwrap in a test reports its line.
#![allow(clippy::unwrap_used)]

#[path = "../bath/mod.rs"]
mod bath;
mod bodies;
mod closing;
mod exact;
mod filling;

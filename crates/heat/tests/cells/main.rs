//! Closed surfaces and the cells inside them: what is refused, what is kept exactly, and how near the answers are.

// A test that unwraps in vain says where.
#![allow(clippy::unwrap_used)]

#[path = "../bath/mod.rs"]
mod bath;
mod bodies;
mod closing;
mod exact;
mod filling;

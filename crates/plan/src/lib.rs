//! Fits: what a kitchen at home has otherwise than the program's, from what was measured there.
//!
//! This crate hands out jobs and takes their results; it starts no thread, opens no file and reads no clock. A shell runs the
//! jobs of a round in any order, on as many threads as it likes: the answer is the same.

pub mod fit;

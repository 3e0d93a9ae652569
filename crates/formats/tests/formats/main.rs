//! What files of results promise, in one program: one is linked sooner than many.

// A test that fails at an unwrap names its line.
#![allow(clippy::unwrap_used)]

mod fields;
mod gltf;
mod parquet;

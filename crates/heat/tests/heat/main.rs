//! What conduction promises, and the meshes under it, in one program: one is linked sooner than many.

// A test that fails at an unwrap names its line.
#![allow(clippy::unwrap_used)]

mod bath;
mod cells;
mod exact;
mod swept_paths;

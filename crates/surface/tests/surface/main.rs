//! What readers of surfaces promise, in one program: one is linked sooner than many.

// A test that fails at an unwrap names its line.
#![allow(clippy::unwrap_used)]

mod formats;
mod gltf_of_other_tools;
mod hostile;
mod obj_of_other_tools;
mod stl_of_other_tools;

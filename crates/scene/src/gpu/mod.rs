//! Pipelines, buffers and textures.

/// A shader by the name of its file, as `build.rs` made it ready.
macro_rules! shader {
    ($name:literal) => {
        include_str!(concat!(env!("OUT_DIR"), "/", $name, ".wgsl"))
    };
}

pub(crate) mod backdrop;
pub(crate) mod clip;
pub(crate) mod dirty;
pub(crate) mod foods;
pub(crate) mod history;
pub mod overlay;
pub(crate) mod passes;
pub(crate) mod pipeline_build;
pub(crate) mod pipeline_set;
pub(crate) mod pipelines;
pub(crate) mod post;
pub mod readback;
pub(crate) mod shown;
pub(crate) mod solids;
pub(crate) mod sprites;
pub(crate) mod still;
pub(crate) mod targets;
pub(crate) mod textures;
pub(crate) mod uniforms;
pub(crate) mod views;

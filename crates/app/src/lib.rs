//! The window of saute: renderer, panels, input.

pub mod scene;

//! The pan's film, heat tint and spatter as the renderer's input.

pub(crate) mod film;
pub(crate) mod spatter;
pub(crate) mod tint;

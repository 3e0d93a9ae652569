//! Files that the command reads: recipes, the library with the user's data folder, surfaces.

pub mod data_library;
pub mod folder;
pub mod recipe_source;
pub mod session_source;
pub mod surface_file;
pub mod text_file;

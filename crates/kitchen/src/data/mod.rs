//! Data files: what a kitchen is built from. The types of the descriptions state each format once.

pub mod at_home;
pub mod data_file;
mod data_hash;
pub mod echo;
pub mod finding;
pub mod food_check;
pub mod format;
mod format_page;
pub mod goals;
pub mod input_error;
pub mod library;
pub mod library_error;
pub mod loading;
pub mod number_text;
pub mod regular_file;
mod relations;
pub mod room;
mod schema_text;
mod schema_walk;
mod shelf;

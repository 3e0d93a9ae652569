//! The library: data folders, lists, schemas and the check of a food.

mod data_folder;
mod food_check;
mod format_pages;
mod lists;
mod schema;

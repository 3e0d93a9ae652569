//! The library: data folders, lists, schemas and the check of a food.

mod broken_data;
mod data_folder;
mod food_check;
mod format_pages;
mod hostile_files;
mod lists;
mod new_food;
mod pipes_and_links;
mod schema;

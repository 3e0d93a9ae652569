//! The library: data folders, lists, schemas and the check of a food.

mod data_folder;
mod food_check;
mod lists;
mod schema;

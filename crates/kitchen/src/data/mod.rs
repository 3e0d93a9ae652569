//! Data files: what a kitchen is built from. The types of the descriptions state each format once.

pub mod at_home;
mod data_hash;
pub mod food_check;
#[cfg(test)]
mod formats;
pub mod goals;
pub mod library;
pub mod loading;
mod relations;
pub mod room;
mod shelf;

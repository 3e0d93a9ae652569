//! Data files: what a kitchen is built from, each format with its checks.

mod data_check;
pub mod food_check;
pub mod input_error;
pub mod library;
pub mod room;

//! The commands that need one file each.

pub mod cook;
pub mod food_check;
pub mod lab;
pub mod list;
mod list_actions;
pub mod manual;
pub mod open;
pub mod replay;
pub mod schema;

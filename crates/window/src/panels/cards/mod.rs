//! Cards over everything: first steps, keys, messages.

pub mod files;
pub mod first_steps;
pub mod frame;
pub mod goals;
pub mod help;
pub mod language;
pub mod learn;
pub mod lessons;
pub mod messages;
pub mod mirror;
pub mod result;
pub mod serving;
pub mod setting_row;
pub mod settings;
pub mod unfinished;

//! Hob, pan, foods, commands and time: the one API that outsiders need.
//!
//! A [`Kitchen`] is a pure function of its model, its state and the [`Command`]s it gets; [`Kitchen::step`] moves it
//! by one [`TICK_S`]. It never fails, reads no clock and opens no file.

pub mod board;
pub mod carry_over;
pub mod cloth;
pub mod command;
pub mod contact;
pub mod cook;
pub mod cook_case;
mod data_check;
pub mod energy;
pub mod food_check;
pub mod hob;
mod input_error;
pub mod kitchen;
pub mod lab;
pub mod library;
pub mod pan;
pub mod piece;
pub mod recipe;
mod recipe_check;
pub mod recipe_file;
pub mod recorder;
pub mod room;
pub mod runner;
pub mod summary;

pub use command::{Command, Refused, RestOn};
pub use cook::{Cook, Fired};
pub use input_error::InputError;
pub use kitchen::{Kitchen, PieceOrder};
pub use library::{Library, LibraryError};
pub use piece::{Piece, Place};
pub use recipe::{Action, Recipe, Step, Trigger};
pub use recorder::Recorder;
pub use runner::{Runner, StoppedBy};
pub use saute_food as food;
pub use saute_heat as heat;
pub use summary::Summary;

/// Length of one tick [s].
pub const TICK_S: f64 = 0.1;

/// Temperature in kelvin from °C.
pub fn kelvin(celsius: f64) -> f64 {
    celsius + saute_food::ZERO_C
}

/// Temperature in °C from kelvin.
pub fn celsius(kelvin: f64) -> f64 {
    kelvin - saute_food::ZERO_C
}

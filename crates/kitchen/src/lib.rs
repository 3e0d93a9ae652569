//! Hob, pan, foods, commands and time: the one API that outsiders need.
//!
//! A [`Kitchen`] is a pure function of its model, its state and the [`Command`]s it gets; [`Kitchen::step`] moves it
//! by one [`TICK_S`]. It never fails, reads no clock and opens no file.

mod action_check;
pub mod action_file;
pub mod bed;
pub mod board;
pub mod butter;
pub mod carry_over;
pub mod cloth;
pub mod command;
pub mod contact;
pub mod cook;
pub mod cook_case;
pub mod course;
mod data_check;
pub mod drop_flight;
pub mod dynamics;
pub mod energy;
pub mod event;
pub mod film_flow;
pub mod fond;
pub mod food_check;
mod food_contact;
pub mod group_summary;
mod heat_tick;
pub mod heat_tint;
pub mod hob;
mod input_error;
pub mod kitchen;
mod knife;
pub mod lab;
pub mod layout;
mod lead;
pub mod library;
pub mod lid;
pub mod liquids;
mod motion;
mod near_pan;
pub mod oil;
pub mod oil_film;
mod orders;
pub mod pan;
pub mod pan_description;
pub mod piece;
mod pour;
pub mod recipe;
mod recipe_check;
pub mod recipe_file;
pub mod recorder;
pub mod ridges;
pub mod room;
pub mod runner;
pub mod sear_lines;
mod sequence_check;
pub mod shorthand;
pub mod smoke;
pub mod solids_rates;
pub mod spatter;
pub mod step_record;
pub mod summary;
mod watch;
pub mod water_film;

pub use command::{Command, Refused, RestOn};
pub use cook::{Cook, Fired};
pub use event::{Event, EventKind, EventLog};
pub use input_error::InputError;
pub use kitchen::{Kitchen, PieceOrder};
pub use library::{Library, LibraryError};
pub use piece::{Piece, Place};
pub use recipe::{Action, Deed, Group, Recipe, Step, Target, Trigger};
pub use recorder::Recorder;
pub use runner::{Runner, StoppedBy};
pub use saute_food as food;
pub use saute_food::MeshSize;
pub use saute_heat as heat;
pub use summary::Summary;

/// Length of one tick [s].
pub const TICK_S: f64 = 0.1;

/// Frames in a tick.
pub const FRAMES_PER_TICK: u32 = 6;

/// Length of one frame [s]: what a display shows at once, and the smallest step that can be asked for.
pub const FRAME_S: f64 = TICK_S / FRAMES_PER_TICK as f64;

/// Temperature in kelvin from °C.
pub fn kelvin(celsius: f64) -> f64 {
    celsius + saute_food::ZERO_C
}

/// Temperature in °C from kelvin.
pub fn celsius(kelvin: f64) -> f64 {
    kelvin - saute_food::ZERO_C
}

//! Hob, pan, foods, commands and time: the one API that outsiders need.
//!
//! A [`Kitchen`] is a pure function of its model, its state and the [`Command`]s it gets; [`Kitchen::step`] moves it
//! by one [`TICK_S`]. It never fails, reads no clock and opens no file.

pub mod advice;
pub mod data;
pub mod dynamics;
pub mod hands;
pub mod kitchen;
pub mod liquids;
pub mod pan;
pub mod piece;
pub mod tick;

pub use data::{food_check, library, room};
pub use hands::command;
pub use liquids::{butter, drop_flight, film_flow, fond, oil, oil_film, smoke, solids_rates, spatter, water_film};
pub use pan::{bed, cloth, heat_tint, hob, lid, pan_description, ridges};
pub use piece::{board, carry_over, contact, layout, sear_lines};
pub use tick::{energy, event};

pub use command::{Command, Refused, RestOn};
pub use data::input_error::{InputError, InputText};
pub use event::{Event, EventKind, EventLog};
pub use kitchen::{Kitchen, PieceOrder};
pub use library::{Library, LibraryError};
pub use piece::{Piece, Place};
pub use saute_food as food;
pub use saute_food::MeshSize;
pub use saute_heat as heat;

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

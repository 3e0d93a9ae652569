//! Simulates a kitchen: hob, pan, liquids, foods, hands and time.
//!
//! A [`Kitchen`] is a pure function of its model, its state and its [`Command`]s. [`Kitchen::step`] advances it by one
//! tick of [`TICK_S`]; it never fails, reads no clock and opens no file.
//!
//! ```
//! use saute_kitchen::food::Rules;
//! use saute_kitchen::{Command, Kitchen, Library, MeshSize, OutlineKind, PieceOrder, celsius, kelvin};
//!
//! let library = Library::embedded()?;
//! let mut kitchen = Kitchen::new(&library, "carbon-steel-26", kelvin(200.0))?;
//! let steak = PieceOrder {
//!     id: "steak".into(),
//!     kind: "beef-lean".into(),
//!     size: [0.120, 0.080, 0.012],
//!     temperature: kelvin(20.0),
//!     seed: 1,
//!     coarseness: 1.0,
//!     rules: Rules::Full,
//!     mesh: MeshSize::Paper2013,
//!     outline: OutlineKind::Plain,
//! };
//! kitchen.add(&library, &steak)?;
//! kitchen.apply(&Command::Hob(700.0))?;
//! kitchen.apply(&Command::Put { food: "steak".into(), at: [0.0, 0.0], heap: false })?;
//! while kitchen.time_s() < 60.0 {
//!     kitchen.step();
//! }
//! kitchen.apply(&Command::Flip { food: "steak".into() })?;
//! while kitchen.time_s() < 120.0 {
//!     kitchen.step();
//! }
//! let core_c = celsius(kitchen.pieces()[0].core());
//! assert!((38.0..50.0).contains(&core_c), "{core_c} °C");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod advice;
pub mod bytes;
pub mod data;
pub mod doneness;
pub mod dynamics;
pub mod hands;
pub mod kitchen;
pub mod liquids;
pub mod pan;
pub mod piece;
pub mod reduced;
pub mod tick;

pub use data::library::Library;
pub use data::loading::OwnFiles;
pub use hands::command::{Command, Refused, RestOn};
pub use kitchen::{Kitchen, PieceOrder};
pub use pan::hold::Holding;
pub use piece::{Piece, Place};
pub use saute_food as food;
pub use saute_food::{MeshSize, OutlineKind};
pub use saute_heat as heat;
pub use tick::event::{Event, EventKind, EventLog};

/// Length of one tick [s].
pub const TICK_S: f64 = 0.1;

/// Ticks in a second [-].
pub const TICKS_PER_S: u32 = (1.0 / TICK_S + 0.5) as u32;

/// Frames in a tick [-].
pub const FRAMES_PER_TICK: u32 = 6;

/// Length of one frame, the smallest step of [`Kitchen::advance_frame`] [s].
pub const FRAME_S: f64 = TICK_S / FRAMES_PER_TICK as f64;

/// Converts a temperature from °C to kelvin [K].
///
/// ```
/// assert_eq!(saute_kitchen::kelvin(100.0), 373.15);
/// ```
pub fn kelvin(celsius: f64) -> f64 {
    celsius + saute_food::ZERO_C
}

/// Converts a temperature from kelvin to °C [°C].
pub fn celsius(kelvin: f64) -> f64 {
    kelvin - saute_food::ZERO_C
}

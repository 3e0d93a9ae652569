//! Makes the sound of a frying pan from the state of a kitchen: steam, temperatures, blows. It does not depend on a kitchen.
//!
//! A [`Synth`] takes a [`Snapshot`] and [`Event`]s for each tick of [`TICK_S`] and renders samples in blocks of any length. The
//! samples depend on what came in at which sample, never on the length of the blocks. All transcendental functions come from
//! `libm`, so every platform makes the same bits. Memory is allocated in [`Synth::new`] only.
//!
//! ```
//! use saute_sound::{Metal, Plate, Snapshot, Steam, Synth};
//!
//! let pan = Plate { metal: Metal::CarbonSteel, radius_m: 0.115, thickness_m: 2.3e-3 };
//! let mut synth = Synth::new(48_000, 1, &pan);
//! let mut second = vec![[0.0; 2]; 48_000];
//!
//! // A cold pan is silent.
//! synth.feed(&Snapshot::default(), &[]);
//! synth.render(&mut second);
//! assert!(second.iter().all(|frame| *frame == [0.0; 2]));
//!
//! // A tenth of a gram of steam a second sizzles.
//! let frying = Snapshot { floor_c: 180.0, ..Snapshot::default() }.with(Steam::Floor, 0.1e-3);
//! synth.feed(&frying, &[]);
//! synth.render(&mut second);
//! assert!(second.iter().any(|frame| frame[0].abs() > 0.01));
//! ```
#![no_std]

extern crate alloc;

mod bubbles;
mod character;
mod event;
mod event_queue;
mod filter;
mod glide;
mod hiss;
pub mod letter;
mod lid;
mod limiter;
mod loudness;
mod player;
mod pour;
mod random;
mod snapshot;
mod stove;
mod stove_sound;
mod struck;
mod synth;

pub use event::{Event, EventKind, TICK_S};
pub use limiter::CEILING;
pub use loudness::SILENCE_DB;
pub use player::{Player, Told};
pub use snapshot::{Snapshot, Steam};
pub use stove::Stove;
pub use struck::plate::{Metal, Plate};
pub use synth::{RATES, SEED, Synth};

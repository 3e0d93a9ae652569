//! A kitchen as bytes and back, exactly.
//!
//! [`Kitchen::to_bytes`](crate::Kitchen::to_bytes) stores the state of a kitchen with everything that a step reads: pieces with their
//! fields and contacts, rigid bodies with the tables of their solver, pan, liquids, hands, tasks, events and clock. A kitchen that
//! was restored goes on bit by bit as the one that never stopped, also in the middle of a toss. Models are not stored: they are built
//! again from their descriptions, or shared with those that are known ([`Models`]).
//!
//! The bytes begin with a header: magic number, version of the format, version of the program and a checksum. Then come the hashes of
//! the data files that the kitchen is built from, and the state, in [postcard](https://postcard.jamesmunns.com/). Bytes of another
//! version, of other data, or damaged bytes are refused with a reason. The checksum finds damage and chance; it is no signature, and the
//! tables of the rigid-body solver are trusted if it matches.
//!
//! ```
//! use saute_kitchen::{Command, Kitchen, Library, kelvin};
//!
//! let library = Library::embedded()?;
//! let mut kitchen = Kitchen::new(&library, "carbon-steel-26", kelvin(180.0))?;
//! kitchen.apply(&Command::Water(0.02))?;
//! kitchen.step();
//! let mut restored = Kitchen::from_bytes(&kitchen.to_bytes(), &library)?;
//! kitchen.step();
//! restored.step();
//! assert_eq!(kitchen.state_hash(), restored.state_hash());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod bytes_error;
mod hashing;
mod header;
mod models;
mod saved_kitchen;
mod saved_pan;
mod saved_piece;
mod sources;
mod storing;

pub use bytes_error::BytesError;
pub(crate) use hashing::hash_of;
pub use header::sealed;
pub(crate) use models::FoodKey;
pub use models::Models;

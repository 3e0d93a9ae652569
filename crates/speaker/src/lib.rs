//! Plays the sound of a kitchen on the sound card of this machine.
//!
//! A [`Speaker`] owns a thread with a [`saute_sound::Player`] and a device ([`Device`]). The owner of the kitchen sends it what there is to
//! hear once a picture; neither side ever waits for the other: states go through a triple buffer, events through a bounded queue of
//! which the weakest are dropped and counted.
//!
//! The system's library of sound is opened at run time ([`alsa`]): a program with this crate in it builds and starts where that library,
//! or any sound card, is missing, and reports once that there is no sound.

#[cfg(target_os = "linux")]
pub mod alsa;
mod device;
mod events;
mod speaker;
mod system;

pub use device::{BLOCK, Device, Trouble};
pub use events::QUEUED;
pub use speaker::{Opening, Speaker};
pub use system::system;

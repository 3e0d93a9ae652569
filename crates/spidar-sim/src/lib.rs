//! A simulated SPIDAR: eight motors and strings, a real pan on them, and a hand.
//!
//! It shares no code with its driver, only the protocol in docs/spidar-protocol.md.

mod args;
mod arm;
mod codec;
mod faults;
mod firmware;
mod pairing;
mod pan_body;
mod random;
mod rig;
mod rig_file;
mod scene;
mod server;
mod session;
mod string_drive;
mod truth_log;

pub use args::Args;
pub use firmware::Device;
pub use rig_file::RigFileError;
pub use scene::Making;
pub use server::{ServeError, run};

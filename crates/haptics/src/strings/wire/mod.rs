//! The SPIDAR protocol, version 1, on the host's side; `docs/spidar-protocol.md` defines it.

pub mod frame;
pub mod link;
pub mod message;
pub mod serial;
pub mod stuffing;

pub use frame::{FRAME, Frame, FrameError};
pub use link::{Link, UdpLink};
pub use message::{Caps, Command, DeviceState, FaultCode, Hello, Message, Refusal, Sample, Units};
pub use serial::SerialLink;
pub use stuffing::{Deframer, STUFFED, stuff};

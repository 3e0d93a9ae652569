//! The SPIDAR protocol, version 2, on the host's side; `docs/spidar-protocol.md` defines it.

pub mod frame;
pub mod link;
pub mod message;
pub mod serial;
pub mod stuffing;

pub use frame::{FRAME, Frame, FrameError, VERSION};
pub use link::{Link, UdpLink};
pub use message::{Caps, Command, DeviceState, FaultCode, Hello, Message, Refusal, Refused, Sample, Units};
pub use serial::SerialLink;
pub use stuffing::{Deframer, STUFFED, stuff};

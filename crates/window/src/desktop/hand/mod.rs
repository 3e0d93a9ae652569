//! Haptic devices in the window: hands that hold the pan and lead the turner.

mod choice;
mod connected;
pub mod hands;
mod panel;
pub(crate) mod strings_view;

pub(crate) use choice::{Choice, section};
pub use connected::{ConnectError, Connected};
pub use hands::{Hands, HandsStart, Role};
pub(crate) use panel::{make_room, show};

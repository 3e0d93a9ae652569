//! Haptic devices in the window: hands that hold the pan and lead the turner.

mod choice;
mod connected;
mod hands;
mod in_window;
mod panel;
mod strings_view;

pub(crate) use choice::{Choice, section};
pub use connected::{ConnectError, Connected};
pub use hands::{Hands, HandsStart, Role};
pub(crate) use panel::{make_room, show};

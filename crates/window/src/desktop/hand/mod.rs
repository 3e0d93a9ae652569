//! Haptic devices in the window: hands that hold the pan and lead the turner.

mod choice;
mod panel;
pub(crate) mod strings_view;

pub(crate) use choice::{Choice, section};
pub(crate) use panel::{make_room, show};

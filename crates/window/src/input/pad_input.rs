//! The gamepad in the window: its state from frame to frame.

use crate::input::gamepad::PadState;
use saute_haptics::DoublePulse;

/// The gamepad with its last state.
#[derive(Default)]
pub(crate) struct Pad {
    /// True if a device is plugged in; its state is dropped when it is unplugged.
    pub(crate) plugged: bool,
    pub(crate) now: PadState,
    pub(crate) before: PadState,
    /// What is felt when the goal is reached.
    pub(crate) pulse: DoublePulse,
    /// True while the coach states that the food is to be taken out.
    pub(crate) at_goal: bool,
}

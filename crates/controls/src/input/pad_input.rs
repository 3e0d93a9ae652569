//! The gamepad in the window: its state from frame to frame.

use crate::input::gamepad::PadState;
use saute_haptics::DoublePulse;

/// The gamepad with its last state.
#[derive(Default)]
pub struct Pad {
    /// True if a device is plugged in; its state is dropped when it is unplugged.
    pub plugged: bool,
    /// Its state in this frame.
    pub now: PadState,
    /// Its state in the frame before.
    pub before: PadState,
    /// What is felt when the goal is reached.
    pub pulse: DoublePulse,
    /// True while the coach states that the food is to be taken out.
    pub at_goal: bool,
}

//! The gamepad that the page's script reads.

use saute_haptics::Rumble;

use super::host::Host;
use saute_controls::input::gamepad::{PadButton, PadState};

/// Numbers before the buttons: both sticks to the right and up, both triggers.
const AXES: usize = 6;

/// State of the first gamepad; none where none is plugged in.
pub(crate) fn read(host: &Host) -> Option<PadState> {
    let said = host.read_pad()?;
    let (axes, buttons) = said.split_at_checked(AXES)?;
    let mut down = [false; PadButton::ALL.len()];
    down.iter_mut().zip(buttons).for_each(|(down, value)| *down = *value > 0.0);
    Some(PadState {
        left: [axes[0], axes[1]],
        right: [axes[2], axes[3]],
        left_trigger: axes[4],
        right_trigger: axes[5],
        down,
    })
}

/// Lets the motors of the first gamepad turn so fast; nothing where it has none.
pub(crate) fn shake(host: &Host, rumble: &Rumble) {
    host.shake_pad(rumble.strong, rumble.weak);
}

//! The gamepad that is plugged in: the first one there is.

use gilrs::{Axis, Button, Gamepad, Gilrs};

use crate::gamepad::{PadButton, PadState};

/// The system's gamepads; none where it offers no access to them.
#[derive(Default)]
pub(crate) struct GamepadDevice {
    pads: Option<Gilrs>,
}

impl GamepadDevice {
    /// Looks for gamepads from now on.
    pub(crate) fn connect() -> Self {
        Self { pads: Gilrs::new().ok() }
    }

    /// What the first gamepad says; none where none is plugged in.
    pub(crate) fn read(&mut self) -> Option<PadState> {
        let pads = self.pads.as_mut()?;
        while pads.next_event().is_some() {}
        let (_, pad) = pads.gamepads().next()?;
        Some(state(&pad))
    }
}

fn state(pad: &Gamepad<'_>) -> PadState {
    let axis = |axis| f64::from(pad.value(axis));
    let trigger = |button| pad.button_data(button).map_or(0.0, |data| f64::from(data.value()));
    PadState {
        left: [axis(Axis::LeftStickX), axis(Axis::LeftStickY)],
        right: [axis(Axis::RightStickX), axis(Axis::RightStickY)],
        left_trigger: trigger(Button::LeftTrigger2),
        right_trigger: trigger(Button::RightTrigger2),
        down: PadButton::ALL.map(|button| pad.is_pressed(named(button))),
    }
}

fn named(button: PadButton) -> Button {
    match button {
        PadButton::South => Button::South,
        PadButton::East => Button::East,
        PadButton::West => Button::West,
        PadButton::North => Button::North,
        PadButton::Up => Button::DPadUp,
        PadButton::Down => Button::DPadDown,
        PadButton::Left => Button::DPadLeft,
        PadButton::Right => Button::DPadRight,
        PadButton::LeftShoulder => Button::LeftTrigger,
        PadButton::RightShoulder => Button::RightTrigger,
        PadButton::Start => Button::Start,
        PadButton::Select => Button::Select,
    }
}

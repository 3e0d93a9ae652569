//! The gamepad that is plugged in: the first one there is.

use gilrs::ff::{BaseEffect, BaseEffectType, Effect, EffectBuilder, Repeat, Replay, Ticks};
use gilrs::{Axis, Button, Gamepad, GamepadId, Gilrs};
use saute_haptics::Rumble;

use crate::input::gamepad::{PadButton, PadState};

/// The system's gamepads; none where it offers no access to them.
#[derive(Default)]
pub struct GamepadDevice {
    pads: Option<Gilrs>,
    /// Strong and weak motor of a gamepad.
    motors: Option<(GamepadId, [Motor; 2])>,
}

/// Gains nearer than this are one [-] (chosen: less is not felt; each is a message).
const ONE_GAIN: f32 = 0.02;
/// Length of an effect, which is repeated without end [ms] (chosen).
const EFFECT_MS: u32 = 1000;

/// A motor that turns all the time, more or less.
struct Motor {
    effect: Effect,
    gain: f32,
}

impl GamepadDevice {
    /// Looks for gamepads from now on.
    pub fn connect() -> Self {
        Self { pads: Gilrs::new().ok(), motors: None }
    }

    /// State of the first gamepad; none where none is plugged in.
    pub fn read(&mut self) -> Option<PadState> {
        let pads = self.pads.as_mut()?;
        while pads.next_event().is_some() {}
        let (_, pad) = pads.gamepads().next()?;
        Some(state(&pad))
    }

    /// Lets the motors of the first gamepad turn so fast; nothing where it has none.
    pub fn shake(&mut self, rumble: &Rumble) {
        let Some(pads) = &mut self.pads else { return };
        let first = pads.gamepads().next().filter(|(_, pad)| pad.is_ff_supported()).map(|(id, _)| id);
        if self.motors.as_ref().map(|(id, _)| *id) != first {
            self.motors = first.and_then(|id| Some((id, [strong(pads, id)?, weak(pads, id)?])));
        }
        if let Some((_, [strong, weak])) = &mut self.motors {
            strong.turn(rumble.strong);
            weak.turn(rumble.weak);
        }
    }
}

impl Motor {
    /// A motor at rest; none where the system refuses it.
    fn at_rest(pads: &mut Gilrs, id: GamepadId, kind: BaseEffectType) -> Option<Self> {
        let scheduling = Replay { play_for: Ticks::from_ms(EFFECT_MS), ..Replay::default() };
        let base = BaseEffect { kind, scheduling, ..BaseEffect::default() };
        let mut builder = EffectBuilder::new();
        builder.add_effect(base).repeat(Repeat::Infinitely).gain(0.0).gamepads(&[id]);
        let effect = builder.finish(pads).ok()?;
        effect.play().ok()?;
        Some(Self { effect, gain: 0.0 })
    }

    fn turn(&mut self, share: f64) {
        let gain = share.clamp(0.0, 1.0) as f32;
        let rests = gain == 0.0 && self.gain != 0.0;
        if rests || (gain - self.gain).abs() > ONE_GAIN {
            self.gain = gain;
            // A gamepad that is pulled out at this moment is missed at the next reading.
            let _ = self.effect.set_gain(gain);
        }
    }
}

fn strong(pads: &mut Gilrs, id: GamepadId) -> Option<Motor> {
    Motor::at_rest(pads, id, BaseEffectType::Strong { magnitude: u16::MAX })
}

fn weak(pads: &mut Gilrs, id: GamepadId) -> Option<Motor> {
    Motor::at_rest(pads, id, BaseEffectType::Weak { magnitude: u16::MAX })
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

//! The gamepad in the window: its state from frame to frame.

use crate::app::SauteApp;
use crate::host::Host;
use egui::Context;
use saute_controls::input::gamepad::{PadMotion, PadState, acts, motion};

impl SauteApp {
    /// Sets the gamepad's state, until one that is plugged in reports another.
    pub fn set_pad(&mut self, state: PadState) {
        self.inputs.pad.now = state;
    }

    /// Lets a gamepad that is plugged in shake as it feels in the pan, and pulse at the goal.
    pub(crate) fn shake_pad(&mut self, ctx: &Context) {
        let wall = ctx.input(|i| f64::from(i.stable_dt));
        let pulse = self.inputs.pad.pulse.step(wall);
        if self.inputs.pad.plugged {
            let rumble = self.session.hands.rumble(wall).or(pulse);
            self.host.turn_motors(&rumble);
        }
        if self.inputs.pad.pulse.is_on() {
            ctx.request_repaint();
        }
    }

    /// Begins the double pulse of a gamepad when the coach begins to state that the food is to be taken out.
    pub(crate) fn pulse_at_goal(&mut self, at_goal: bool) {
        if at_goal && !self.inputs.pad.at_goal {
            self.inputs.pad.pulse.begin();
        }
        self.inputs.pad.at_goal = at_goal;
    }

    /// Returns true while a gamepad pulses because the goal is reached.
    pub fn pad_pulses(&self) -> bool {
        self.inputs.pad.pulse.is_on()
    }

    fn listen(&mut self) {
        let said = self.host.read_pad();
        if said.is_some() || self.inputs.pad.plugged {
            self.inputs.pad.now = said.unwrap_or_default();
        }
        self.inputs.pad.plugged = said.is_some();
    }

    /// Carries out what the gamepad's buttons request and returns what its sticks do.
    pub(crate) fn take_pad(&mut self, ctx: &Context) -> PadMotion {
        self.listen();
        let (before, now) = (self.inputs.pad.before, self.inputs.pad.now);
        self.inputs.pad.before = now;
        acts(&before, &now).for_each(|act| self.act(act, ctx));
        motion(&now)
    }
}

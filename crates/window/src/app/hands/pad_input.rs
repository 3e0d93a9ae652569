//! The gamepad in the window: its state from frame to frame.

use crate::app::SauteApp;
use crate::input::gamepad::{PadMotion, PadState, acts, motion};
use egui::Context;
use saute_haptics::Rumble;

impl SauteApp {
    /// Sets the gamepad's state, until one that is plugged in reports another.
    pub fn set_pad(&mut self, state: PadState) {
        self.pad.now = state;
    }

    #[cfg(not(target_arch = "wasm32"))]
    fn read_pad(&mut self) -> Option<PadState> {
        self.pad.device.read()
    }

    #[cfg(target_arch = "wasm32")]
    fn read_pad(&mut self) -> Option<PadState> {
        self.host.as_ref().and_then(crate::browser::gamepad::read)
    }

    #[cfg(not(target_arch = "wasm32"))]
    fn turn_motors(&mut self, rumble: &Rumble) {
        self.pad.device.shake(rumble);
    }

    #[cfg(target_arch = "wasm32")]
    fn turn_motors(&mut self, rumble: &Rumble) {
        if let Some(host) = &self.host {
            crate::browser::gamepad::shake(host, rumble);
        }
    }

    /// Lets a gamepad that is plugged in shake as it feels in the pan, and pulse at the goal.
    pub(crate) fn shake_pad(&mut self, ctx: &Context) {
        let wall = ctx.input(|i| f64::from(i.stable_dt));
        let pulse = self.pad.pulse.step(wall);
        if self.pad.plugged {
            let rumble = self.session.hands.rumble(wall).or(pulse);
            self.turn_motors(&rumble);
        }
        if self.pad.pulse.is_on() {
            ctx.request_repaint();
        }
    }

    /// Begins the double pulse of a gamepad when the coach begins to say that the food is to be taken out.
    pub(crate) fn pulse_at_goal(&mut self, at_goal: bool) {
        if at_goal && !self.pad.at_goal {
            self.pad.pulse.begin();
        }
        self.pad.at_goal = at_goal;
    }

    /// Returns true while a gamepad pulses because the goal is reached.
    pub fn pad_pulses(&self) -> bool {
        self.pad.pulse.is_on()
    }

    fn listen(&mut self) {
        let said = self.read_pad();
        if said.is_some() || self.pad.plugged {
            self.pad.now = said.unwrap_or_default();
        }
        self.pad.plugged = said.is_some();
    }

    /// Carries out what the gamepad's buttons ask for and returns what its sticks do.
    pub(crate) fn take_pad(&mut self, ctx: &Context) -> PadMotion {
        self.listen();
        let (before, now) = (self.pad.before, self.pad.now);
        self.pad.before = now;
        acts(&before, &now).for_each(|act| self.act(act, ctx));
        motion(&now)
    }
}

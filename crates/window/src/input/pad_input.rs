//! The gamepad in the window: its state from frame to frame.

use egui::Context;

use crate::app::SauteApp;
use crate::input::gamepad::{PadMotion, PadState, acts, motion};
#[cfg(not(target_arch = "wasm32"))]
use crate::input::gamepad_device::GamepadDevice;

/// The gamepad, and what it said last.
#[derive(Default)]
pub(crate) struct Pad {
    #[cfg(not(target_arch = "wasm32"))]
    device: GamepadDevice,
    /// Whether a device is plugged in: once it is gone, so is what it said.
    #[cfg(not(target_arch = "wasm32"))]
    plugged: bool,
    now: PadState,
    before: PadState,
}

impl Pad {
    /// Listens to the gamepad that is plugged in; in a browser to none.
    pub(crate) fn connected() -> Self {
        Self {
            #[cfg(not(target_arch = "wasm32"))]
            device: GamepadDevice::connect(),
            ..Self::default()
        }
    }
}

#[cfg(not(target_arch = "wasm32"))]
impl Pad {
    /// Whether a device is plugged in.
    pub(crate) fn is_plugged(&self) -> bool {
        self.plugged
    }

    /// Lets its motors shake.
    pub(crate) fn shake(&mut self, rumble: &saute_haptics::Rumble) {
        self.device.shake(rumble);
    }
}

impl SauteApp {
    /// Lets a gamepad say something, until one that is plugged in says otherwise.
    pub fn set_pad(&mut self, state: PadState) {
        self.pad.now = state;
    }

    #[cfg(not(target_arch = "wasm32"))]
    fn listen(&mut self) {
        let said = self.pad.device.read();
        if said.is_some() || self.pad.plugged {
            self.pad.now = said.unwrap_or_default();
        }
        self.pad.plugged = said.is_some();
    }

    /// Does what the gamepad's buttons ask for and tells what its sticks do.
    pub(crate) fn take_pad(&mut self, ctx: &Context) -> PadMotion {
        #[cfg(not(target_arch = "wasm32"))]
        self.listen();
        let (before, now) = (self.pad.before, self.pad.now);
        self.pad.before = now;
        acts(&before, &now).for_each(|act| self.act(act, ctx));
        motion(&now)
    }
}

//! Hands in a page: the pan that the phone holds, and what a gamepad feels. A page reaches no other device.

use crate::app::SauteApp;
use saute_controls::hands::reading;
use saute_haptics::remote::phone::held_phone::HeldPhone;

impl SauteApp {
    /// Takes how the phone is held, or that it was refused.
    pub(super) fn take_tilt(&mut self) {
        let (Some(host), Some(phone)) = (&self.host.script, &mut self.session.hands.phone) else { return };
        let Some(said) = host.read_tilt() else { return };
        match reading(&said) {
            // What is out of range is left out; a silent phone lets go.
            Some((measured, screen_deg)) => {
                let _ = phone.receive(&measured, screen_deg);
            }
            None => {
                self.tilt_phone();
                self.say("pour.tilt_refused");
            }
        }
    }

    /// Lets the phone hold the pan, at the pace of the clock; or no longer.
    pub(super) fn tilt_phone(&mut self) {
        let Some(host) = &self.host.script else { return };
        let holds = self.session.hands.phone.is_none();
        self.session.hands.phone = holds.then(HeldPhone::default);
        host.tilt(holds);
        if holds {
            self.set_speed(1.0);
        }
    }
}

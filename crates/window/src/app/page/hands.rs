//! Hands in a page: the pan that the phone holds, and what a gamepad feels. A page reaches no other device.

use crate::app::SauteApp;
use crate::browser::hands::reading;
use crate::browser::host::Host;
use egui::Context;
use saute_haptics::remote::phone::held_phone::HeldPhone;

impl SauteApp {
    /// Takes how the phone is held, or that it was refused.
    pub(crate) fn take_devices(&mut self, _: &Context) {
        let (Some(host), Some(phone)) = (&self.page.host, &mut self.session.hands.phone) else { return };
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
    pub(crate) fn tilt_phone(&mut self) {
        let Some(host) = &self.page.host else { return };
        let holds = self.session.hands.phone.is_none();
        self.session.hands.phone = holds.then(HeldPhone::default);
        host.tilt(holds);
        if holds {
            self.set_speed(1.0);
        }
    }

    /// Returns true while the phone holds the pan; none where it cannot.
    pub(crate) fn phone_tilts(&self) -> Option<bool> {
        self.page.host.as_ref().filter(|host| Host::can_tilt(host)).map(|_| self.session.hands.phone.is_some())
    }
}

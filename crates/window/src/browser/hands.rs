//! Hands in a page: the pan that the phone holds, and what a gamepad feels. A page reaches no other device.

use egui::Context;
use saute_haptics::remote::phone::held_phone::HeldPhone;
use saute_haptics::remote::phone::message::Measured;
use saute_haptics::{PanInHand, Rumble};
use saute_kitchen::{FRAME_S, Kitchen};

use super::host::Host;
use crate::app::SauteApp;
use crate::input::felt::Felt;

/// Numbers of a reading: three angles, the turn of the picture, then six accelerations, not numbers where they are unknown.
const READING: usize = 10;

/// What hands hold.
#[derive(Default)]
pub struct Hands {
    /// The phone while it holds the pan.
    phone: Option<HeldPhone>,
    pan_in_hand: PanInHand,
    felt: Felt,
}

impl saute_session::hands::Hands for Hands {
    /// A new kitchen: the hand takes hold of it gently.
    fn begin(&mut self) {
        self.pan_in_hand = PanInHand::default();
        self.felt.forget();
    }

    /// Before a frame of the kitchen: the pan goes where the phone holds it.
    fn lead(&mut self, kitchen: &mut Kitchen) {
        let pose = self.phone.as_mut().and_then(|phone| phone.step(FRAME_S));
        self.pan_in_hand.hold(pose.as_ref(), kitchen, FRAME_S);
    }

    /// After a frame at the pace of the clock.
    fn send(&mut self, kitchen: &Kitchen) {
        if self.felt.is_listened() {
            self.felt.look(kitchen);
        }
    }
}

impl Hands {
    /// Returns the rumble of a gamepad now, `wall` after the last call [s].
    pub fn rumble(&mut self, wall: f64) -> Rumble {
        self.felt.rumble(wall)
    }
}

impl SauteApp {
    /// Takes how the phone is held, or that it was refused.
    pub(crate) fn take_devices(&mut self, _: &Context) {
        let (Some(host), Some(phone)) = (&self.host, &mut self.session.hands.phone) else { return };
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
        let Some(host) = &self.host else { return };
        let holds = self.session.hands.phone.is_none();
        self.session.hands.phone = holds.then(HeldPhone::default);
        host.tilt(holds);
        if holds {
            self.set_speed(1.0);
        }
    }

    /// Returns true while the phone holds the pan; none where it cannot.
    pub(crate) fn phone_tilts(&self) -> Option<bool> {
        self.host.as_ref().filter(|host| Host::can_tilt(host)).map(|_| self.session.hands.phone.is_some())
    }
}

/// A reading, and by how much the picture is turned on the phone [°]; none if it was refused.
fn reading(said: &[f64]) -> Option<(Measured, f64)> {
    let said: &[f64; READING] = said.try_into().ok()?;
    let [alpha, beta, gamma, screen_deg, accelerations @ ..] = *said;
    let [push, felt] = [&accelerations[..3], &accelerations[3..]].map(|list| list.try_into().ok());
    let known = |list: Option<[f64; 3]>| list.filter(|list| list.iter().all(|v| v.is_finite()));
    Some((Measured { turn: [alpha, beta, gamma], push: known(push), felt: known(felt) }, screen_deg))
}

//! Hands in a page: the pan that the phone holds, and what a gamepad feels. A page reaches no other device.

use crate::input::felt::Felt;
use saute_haptics::remote::phone::held_phone::HeldPhone;
use saute_haptics::remote::phone::message::Measured;
use saute_haptics::{PanInHand, Rumble};
use saute_kitchen::{FRAME_S, Kitchen};

/// Numbers of a reading: three angles, the turn of the picture, then six accelerations, not numbers where they are unknown.
const READING: usize = 10;

/// What hands hold.
#[derive(Default)]
pub struct Hands {
    /// The phone while it holds the pan.
    pub phone: Option<HeldPhone>,
    /// The pan that the phone leads.
    pub pan_in_hand: PanInHand,
    /// What a gamepad feels.
    pub felt: Felt,
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

/// A reading, and by how much the picture is turned on the phone [°]; none if it was refused.
pub fn reading(said: &[f64]) -> Option<(Measured, f64)> {
    let said: &[f64; READING] = said.try_into().ok()?;
    let [alpha, beta, gamma, screen_deg, accelerations @ ..] = *said;
    let [push, felt] = [&accelerations[..3], &accelerations[3..]].map(|list| list.try_into().ok());
    let known = |list: Option<[f64; 3]>| list.filter(|list| list.iter().all(|v| v.is_finite()));
    Some((Measured { turn: [alpha, beta, gamma], push: known(push), felt: known(felt) }, screen_deg))
}

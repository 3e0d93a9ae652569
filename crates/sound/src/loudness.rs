//! How loud a state sounds, computed from the state alone.

use crate::character::Character;
use crate::lid::through;
use crate::snapshot::{Snapshot, Steam};

/// Level of what cannot be heard [dBFS] (chosen: far below the noise of a quiet room at any volume).
pub const SILENCE_DB: f32 = -90.0;

impl Snapshot {
    /// Level of the steam of one place, under the lid if it is on [dBFS], at least [`SILENCE_DB`]. Its root mean square; blows are not in
    /// it.
    pub fn level_of(&self, place: Steam) -> f32 {
        decibels(self.within_ranges().power(place))
    }

    /// Level of the stove [dBFS], as [`Self::level_of`].
    pub fn level_of_stove(&self) -> f32 {
        let within = self.within_ranges();
        decibels(within.stove.loudness(within.stove_w))
    }

    /// Level of all steam and of the stove [dBFS], as [`Self::level_of`].
    pub fn level(&self) -> f32 {
        let within = self.within_ranges();
        let steam: f32 = Steam::ALL.into_iter().map(|place| within.power(place)).sum();
        decibels(steam + within.stove.loudness(within.stove_w))
    }

    /// Power of the steam of one place that is heard, over that of a full-scale square [-].
    fn power(&self, place: Steam) -> f32 {
        let character = Character::of(place);
        let celsius = if place == Steam::Oil { self.oil_c } else { self.floor_c };
        let power = character.power(self.steam[place as usize], celsius);
        let heard = |hz: f32| if self.lid { through(hz) } else { 1.0 };
        let body = character.body_share * heard(character.body_hz);
        power * (body + (1.0 - character.body_share) * heard(character.air_hz(celsius)))
    }
}

fn decibels(power: f32) -> f32 {
    // No power has no logarithm.
    let least = libm::powf(10.0, 0.1 * SILENCE_DB);
    10.0 * libm::log10f(power.max(least))
}

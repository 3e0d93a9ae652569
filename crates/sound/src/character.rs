//! How the steam of each place sounds: constants.
//!
//! No level or spectrum of a frying steak was found in print, so levels are chosen; one gram of steam a second from under food at
//! 200 °C is −18 dBFS. The levels of the other places are chosen relative to that, each with its reason.

use crate::snapshot::Steam;

/// How the steam of a place sounds.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Character {
    /// Level of 1 g/s at [`REFERENCE_C`] [dBFS], root mean square of all that it is made of.
    pub(crate) level_db: f32,
    /// Rise of the level with temperature [dB/K].
    pub(crate) db_per_k: f32,
    /// Centre of the noise of bursting bubbles at [`REFERENCE_C`] [Hz], and its rise with temperature [Hz/K].
    pub(crate) air_hz: [f32; 2],
    /// Centre of the noise of the bubbles' cloud [Hz].
    pub(crate) body_hz: f32,
    /// Share of the noise's power in the cloud [-].
    pub(crate) body_share: f32,
    /// Bubbles in a kilogram of steam [1/kg].
    pub(crate) per_kg: f32,
    /// Rate of bubbles of which half the power is noise [1/s].
    pub(crate) dense_from: f32,
    /// Least and largest radius of bubbles that are heard singly [m].
    pub(crate) radius_m: [f32; 2],
    /// Damping of those over that of a bubble that is wholly in the liquid [-].
    pub(crate) damped: f32,
}

/// Temperature at which levels and centres are given [°C].
pub(crate) const REFERENCE_C: f32 = 200.0;
/// Rise of the level with the floor's temperature at one flow [dB/K] (chosen: 1 dB for 100 K. An estimate gives 3 to 6, but over a
/// cook the level then follows the stove rather than the steam: rank correlation 0.84 instead of 0.95 and more).
const HOTTER_DB_K: f32 = 0.01;

/// Under food, through a film of oil: bubbles are half exposed and burst rather than ring; 1 to 12 kHz, centroid 3 to 7 kHz
/// (recalled impression, no measurement). 1 g of steam is 1.7 L: bubbles of 1.5 mm make 10⁵ of it.
const FLOOR: Character = Character {
    level_db: -18.0,
    db_per_k: HOTTER_DB_K,
    air_hz: [4500.0, 12.0],
    body_hz: 350.0,
    body_share: 0.12,
    per_kg: 1e8,
    dense_from: 1.2e3,
    radius_m: [0.35e-3, 1.8e-3],
    damped: 3.0,
};
/// In deep oil: larger bubbles (1 to 2 mm ring at 1.7 to 3.4 kHz) that rise freely, with more of a cloud (chosen).
const OIL: Character = Character {
    level_db: -19.0,
    db_per_k: HOTTER_DB_K,
    air_hz: [3000.0, 6.0],
    body_hz: 300.0,
    body_share: 0.3,
    per_kg: 1e8,
    dense_from: 1.2e3,
    radius_m: [0.8e-3, 2.5e-3],
    damped: 1.5,
};
/// Boiling water: bubbles of some millimetres ring at 0.65 to 1.6 kHz, their cloud at 100 to 600 Hz carries most of it. It does not
/// get hotter. Steam in saturated water leaves without a burst: much lower than frying (chosen: −14 dB).
const WATER: Character = Character {
    level_db: -32.0,
    db_per_k: 0.0,
    air_hz: [900.0, 0.0],
    body_hz: 220.0,
    body_share: 0.75,
    per_kg: 1.5e7,
    dense_from: 2e3,
    radius_m: [2e-3, 5e-3],
    damped: 1.0,
};
/// Water of butter: small bubbles under a foam that swallows the highs (chosen: −4 dB, centre at 2.2 kHz).
const BUTTER: Character = Character {
    level_db: -22.0,
    db_per_k: 0.0,
    air_hz: [2200.0, 0.0],
    body_hz: 280.0,
    body_share: 0.35,
    per_kg: 1.5e8,
    dense_from: 1.2e3,
    radius_m: [0.8e-3, 2e-3],
    damped: 2.0,
};
/// Drops and puddles on the hot floor: as under food, but open, therefore brighter and sooner single pops (chosen).
const DRIP: Character = Character {
    level_db: -18.0,
    db_per_k: HOTTER_DB_K,
    air_hz: [5200.0, 12.0],
    body_hz: 400.0,
    body_share: 0.15,
    per_kg: 5e7,
    dense_from: 0.6e3,
    radius_m: [0.4e-3, 2.5e-3],
    damped: 2.5,
};
/// The wet cloth: very loud and broad for half a second to a second (recalled impression).
const CLOTH: Character = Character {
    level_db: -15.0,
    db_per_k: HOTTER_DB_K,
    air_hz: [3500.0, 8.0],
    body_hz: 300.0,
    body_share: 0.2,
    per_kg: 1e8,
    dense_from: 1.2e3,
    radius_m: [0.5e-3, 2e-3],
    damped: 4.0,
};

impl Character {
    /// Returns the character of a place.
    pub(crate) const fn of(place: Steam) -> Self {
        match place {
            Steam::Floor => FLOOR,
            Steam::Oil => OIL,
            Steam::Water => WATER,
            Steam::Butter => BUTTER,
            Steam::Drip => DRIP,
            Steam::Cloth => CLOTH,
        }
    }

    /// Power of a flow [kg/s] at a temperature [°C], over that of a full-scale square [-]. It is proportional to the flow: each
    /// bubble adds its own.
    pub(crate) fn power(&self, flow: f32, celsius: f32) -> f32 {
        let db = self.level_db + self.db_per_k * (celsius - REFERENCE_C);
        1e3 * flow * libm::powf(10.0, 0.1 * db)
    }

    /// Share of the power that is noise, given the rate of bubbles [1/s] [-].
    pub(crate) fn dense_share(&self, rate: f32) -> f32 {
        let over = rate / self.dense_from;
        // A square, so that hiss turns to crackle within a decade of the flow (chosen).
        over * over / (1.0 + over * over)
    }

    /// Centre of the bursting bubbles' noise at a temperature [Hz].
    pub(crate) fn air_hz(&self, celsius: f32) -> f32 {
        (self.air_hz[0] + self.air_hz[1] * (celsius - REFERENCE_C)).max(LOWEST_AIR_HZ)
    }
}

/// Lowest centre of the noise of bursting bubbles [Hz] (chosen: in a pan below 130 °C it burbles, 0.3 to 1.5 kHz).
const LOWEST_AIR_HZ: f32 = 800.0;

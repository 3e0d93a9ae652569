//! Flight of a drop of oil: trajectory and landing.
//!
//! Gravity and linear drag, with the time constant of the drop at its initial speed (Schiller and Naumann):
//! v(t) = v_t + (v_0 − v_t) e^(−t/τ). The frame is the pan's; its origin is the centre of the floor.

use core::f64::consts::{PI, TAU};

use saute_food::GRAVITY;
use serde::{Deserialize, Serialize};

/// Density of hot oil [kg/m³] (standard tables, 120 °C).
pub(crate) const OIL_DENSITY: f64 = 855.0;
/// Density [kg/m³] and viscosity [Pa·s] of warm air over a pan (standard tables, 60 °C).
const AIR: [f64; 2] = [1.06, 2.0e-5];
/// Range of the initial speed [m/s] (chosen: drops rise some 2 to 20 cm, as cooks see and feel them).
const SPEED: [f64; 2] = [0.7, 2.6];
/// Range of the initial elevation [rad] (chosen: bursting bubbles eject steeply, 50° to 86°).
const STEEPNESS: [f64; 2] = [0.87, 1.5];
/// Largest azimuth between a drop from under food and the shortest way out [rad] (chosen: 60°).
const AWAY: f64 = 1.05;
/// Step of the search for the landing [s] (chosen: a drop moves by at most 5 mm).
const STEP: f64 = 2.0e-3;
/// Longest flight [s] (chosen: a drop that rises by 0.3 m is down after half of it).
const LONGEST: f64 = 1.0;

/// Surface on which a flight ends.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq, Serialize)]
pub enum Landing {
    /// The pan's floor; the drop joins the oil.
    Floor,
    /// The pan's wall.
    Wall,
    /// The plane below the pan.
    Outside,
}

/// Geometry for flying drops: the pan's inside and the plane below it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vessel {
    /// Radius of the floor [m].
    pub floor: f64,
    /// Radius at the rim [m].
    pub rim: f64,
    /// Height of the rim above the floor [m].
    pub height: f64,
    /// Height of the floor above the plane below the pan [m].
    pub stands: f64,
}

/// Ballistic flight of one drop.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Serialize)]
pub struct DropFlight {
    /// Start time [s].
    pub thrown_s: f64,
    /// Duration [s].
    pub lasts_s: f64,
    /// Radius of the drop [m].
    pub radius: f64,
    /// Surface at its end.
    pub landing: Landing,
    from: [f64; 3],
    velocity: [f64; 3],
    /// Time constant of its drag [s].
    relaxation: f64,
}

impl Vessel {
    /// Returns the surface that a drop at a place has reached.
    fn landing(&self, [x, y, z]: [f64; 3]) -> Option<Landing> {
        let away = libm::hypot(x, y);
        let wall = self.floor + (self.rim - self.floor) * (z / self.height).max(0.0);
        if z <= 0.0 && away < self.floor {
            Some(Landing::Floor)
        } else if away >= wall && z < self.height && away < self.rim {
            Some(Landing::Wall)
        } else if z <= -self.stands {
            Some(Landing::Outside)
        } else {
            None
        }
    }
}

impl DropFlight {
    /// Launches a drop at a time [s] with a mass [kg] from a place. `chance` contains three random numbers in 0–1 for speed,
    /// elevation and azimuth; `out` is the direction out from under the covering food.
    pub(crate) fn thrown(
        (thrown_s, mass): (f64, f64),
        from: [f64; 3],
        out: Option<[f64; 2]>,
        chance: [f64; 3],
        vessel: &Vessel,
    ) -> Self {
        let between = |[low, high]: [f64; 2], share: f64| low + share * (high - low);
        let (speed, steep) = (between(SPEED, chance[0]), between(STEEPNESS, chance[1]));
        let turn = match out {
            Some([x, y]) => libm::atan2(y, x) + AWAY * (2.0 * chance[2] - 1.0),
            None => TAU * chance[2],
        };
        let level = speed * libm::cos(steep);
        let velocity = [level * libm::cos(turn), level * libm::sin(turn), speed * libm::sin(steep)];
        let radius = libm::cbrt(3.0 * mass / (4.0 * PI * OIL_DENSITY));
        let relaxation = relaxation(radius, speed);
        let mut flight = Self { thrown_s, lasts_s: 0.0, radius, landing: Landing::Outside, from, velocity, relaxation };
        flight.find_end(vessel);
        flight
    }

    fn find_end(&mut self, vessel: &Vessel) {
        let mut age = 0.0;
        while age < LONGEST {
            age += STEP;
            if let Some(landing) = vessel.landing(self.place(age)) {
                self.landing = landing;
                break;
            }
        }
        self.lasts_s = age;
    }

    /// Position at an age since the start [s] [m].
    pub fn place(&self, age: f64) -> [f64; 3] {
        let tau = self.relaxation;
        let slowed = tau * (1.0 - libm::exp(-age / tau));
        let fall = [0.0, 0.0, -GRAVITY * tau];
        core::array::from_fn(|k| self.from[k] + fall[k] * age + (self.velocity[k] - fall[k]) * slowed)
    }

    /// Velocity at an age since the start [s] [m/s].
    pub fn velocity(&self, age: f64) -> [f64; 3] {
        let left = libm::exp(-age / self.relaxation);
        let fall = [0.0, 0.0, -GRAVITY * self.relaxation];
        core::array::from_fn(|k| fall[k] + (self.velocity[k] - fall[k]) * left)
    }

    /// Position at its end [m].
    pub fn end(&self) -> [f64; 3] {
        self.place(self.lasts_s)
    }
}

/// Relaxation time of the drag on a drop at a speed [s].
fn relaxation(radius: f64, speed: f64) -> f64 {
    let [density, viscosity] = AIR;
    let reynolds = 2.0 * radius * speed * density / viscosity;
    let stokes = 2.0 * OIL_DENSITY * radius * radius / (9.0 * viscosity);
    (stokes / (1.0 + 0.15 * libm::pow(reynolds, 0.687))).max(1e-3)
}

#[cfg(test)]
mod tests {
    use super::*;

    const VESSEL: Vessel = Vessel { floor: 0.1, rim: 0.13, height: 0.05, stands: 0.004 };

    fn thrown(mass: f64, chance: [f64; 3]) -> DropFlight {
        DropFlight::thrown((0.0, mass), [0.05, 0.0, 0.0], None, chance, &VESSEL)
    }

    /// Velocity is the slope of the path, and its change gravity less drag.
    #[test]
    fn a_drop_falls_as_gravity_and_drag_have_it() {
        let flight = thrown(1e-7, [0.5, 0.3, 0.2]);
        let h = 1e-5;
        for age in [0.0, 0.05, 0.2] {
            for k in 0..3 {
                let slope = (flight.place(age + h)[k] - flight.place(age - h)[k]) / (2.0 * h);
                let change = (flight.velocity(age + h)[k] - flight.velocity(age - h)[k]) / (2.0 * h);
                let v = flight.velocity(age)[k];
                let pull = if k == 2 { -GRAVITY } else { 0.0 };
                assert!((slope - v).abs() < 1e-6 && (change - pull + v / flight.relaxation).abs() < 1e-5);
            }
        }
    }

    #[test]
    fn a_smaller_drop_is_slowed_more_and_rises_less() {
        let highest = |mass| {
            let flight = thrown(mass, [0.8, 1.0, 0.0]);
            (0..400).map(|i| flight.place(f64::from(i) * 1e-3)[2]).fold(0.0, f64::max)
        };
        let (mist, drop, pop) = (highest(1e-9), highest(1e-7), highest(6e-7));
        assert!(mist < drop && drop < pop && pop < 0.30 && drop > 0.05, "{mist} {drop} {pop}");
    }

    /// A flight ends where it meets the vessel, and nowhere before.
    #[test]
    fn a_drop_flies_until_it_meets_floor_wall_or_what_the_pan_stands_on() {
        let mut seen = Vec::new();
        for i in 0..200 {
            let chance = [1, 7, 13].map(|k| f64::from(i * k % 97) / 97.0);
            let flight = thrown(1e-7, chance);
            assert_eq!(VESSEL.landing(flight.end()), Some(flight.landing));
            assert_eq!(VESSEL.landing(flight.place(0.5 * flight.lasts_s)), None, "{flight:?}");
            seen.push(flight.landing);
        }
        for landing in [Landing::Floor, Landing::Wall, Landing::Outside] {
            assert!(seen.contains(&landing), "{landing:?}");
        }
    }
}

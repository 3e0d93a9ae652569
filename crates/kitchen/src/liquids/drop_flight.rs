//! A drop of oil that flies off the pan: its path through the air, and where it ends.
//!
//! Gravity and a drag in proportion to the speed, whose time constant is that of the drop at the speed it is thrown with
//! (Schiller and Naumann): v(t) = v_t + (v_0 − v_t) e^(−t/τ). The frame is the pan's, its origin the middle of the floor.

use core::f64::consts::{PI, TAU};

use crate::piece::piece_state::GRAVITY;

/// Density of hot oil [kg/m³] (standard tables, 120 °C).
pub(crate) const OIL_DENSITY: f64 = 855.0;
/// Density [kg/m³] and viscosity [Pa·s] of warm air over a pan (standard tables, 60 °C).
const AIR: [f64; 2] = [1.06, 2.0e-5];
/// Slowest and fastest start of a drop [m/s] (chosen: drops rise some 2 to 20 cm, as cooks see and feel them).
const SPEED: [f64; 2] = [0.7, 2.6];
/// Least and greatest angle of a start over the horizontal [rad] (chosen: bursting bubbles throw steeply, 50° to 86°).
const STEEPNESS: [f64; 2] = [0.87, 1.5];
/// How far a drop that comes out from under food may turn from the way out [rad] (chosen: 60°).
const AWAY: f64 = 1.05;
/// Step with which the end of a path is looked for [s] (chosen: a drop moves by 5 mm at most).
const STEP: f64 = 2.0e-3;
/// No drop flies longer than this [s] (chosen: one that rises by 0.3 m is down after half of it).
const LONGEST: f64 = 1.0;

/// Where a flight ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Landing {
    /// Back on the floor, among the oil.
    Floor,
    /// On the pan's wall.
    Wall,
    /// On the plane on which the pan stands.
    Outside,
}

/// What drops fly in: the pan's inside and the plane on which it stands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vessel {
    /// Radius of the floor [m].
    pub floor: f64,
    /// Radius at the rim [m].
    pub rim: f64,
    /// Height of the rim above the floor [m].
    pub height: f64,
    /// Height of the floor above the plane on which the pan stands [m].
    pub stands: f64,
}

/// A drop on its way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DropFlight {
    /// When it was thrown [s].
    pub thrown_s: f64,
    /// How long it flies [s].
    pub lasts_s: f64,
    /// Its radius [m].
    pub radius: f64,
    /// Where it ends.
    pub landing: Landing,
    from: [f64; 3],
    velocity: [f64; 3],
    /// Time constant of its drag [s].
    relaxation: f64,
}

impl Vessel {
    /// Where a drop at a place has landed.
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
    /// A drop of a mass [kg] thrown at a moment [s] from a place; `chance` are three numbers of 0–1 that stand for what is not known
    /// of it, `out` the way out from under the food that covers it.
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

    /// Where it is some time after it was thrown [m].
    pub fn place(&self, age: f64) -> [f64; 3] {
        let tau = self.relaxation;
        let slowed = tau * (1.0 - libm::exp(-age / tau));
        let fall = [0.0, 0.0, -GRAVITY * tau];
        core::array::from_fn(|k| self.from[k] + fall[k] * age + (self.velocity[k] - fall[k]) * slowed)
    }

    /// Its velocity then [m/s].
    pub fn velocity(&self, age: f64) -> [f64; 3] {
        let left = libm::exp(-age / self.relaxation);
        let fall = [0.0, 0.0, -GRAVITY * self.relaxation];
        core::array::from_fn(|k| fall[k] + (self.velocity[k] - fall[k]) * left)
    }

    /// Where it ends [m].
    pub fn end(&self) -> [f64; 3] {
        self.place(self.lasts_s)
    }
}

/// Time constant of the drag on a drop at a speed [s].
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

    /// A flight ends where the vessel says so, and nowhere before.
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

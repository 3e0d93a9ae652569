//! What no hand shall feel more of: force, torque, their change, and energy.

use crate::device::Limits;
use crate::wrench::{Twist, Wrench};

/// Time over which energy is counted [s].
const WINDOW_S: f64 = 1.0;

/// Bounds every wrench, whatever asked for it.
#[derive(Clone, Copy, Debug)]
pub struct SafetyLimits {
    limits: Limits,
    last: Wrench,
    /// Energy given, of which a second later a share of 1/e still counts [J].
    given: f64,
}

impl SafetyLimits {
    /// Begins at rest.
    pub fn new(limits: Limits) -> Self {
        Self { limits, last: Wrench::ZERO, given: 0.0 }
    }

    /// Settles what the last step really gave the hand [J]; what the felt bodies gave of what the hand had put into them,
    /// `back` [J], is the hand's own and does not count. `dt` is a step [s].
    pub fn settle(&mut self, spent: f64, back: f64, dt: f64) {
        let own = if back.is_finite() { back.max(0.0) } else { 0.0 };
        // What cannot be told is taken for all that was left.
        let counts = if spent.is_finite() { (spent - own).max(0.0) } else { self.limits.energy_j };
        self.given = self.given * libm::exp(-dt / WINDOW_S) + counts;
    }

    /// As much of a wrench as the energy that is left of the last second allows; `dt` is a step [s].
    pub fn within_energy(&self, wanted: &Wrench, twist: &Twist, dt: f64) -> Wrench {
        let power = wanted.power(twist);
        if power <= 0.0 || !power.is_finite() {
            return *wanted;
        }
        let left = (self.limits.energy_j - self.given).max(0.0);
        *wanted * (left / (power * dt)).min(1.0)
    }

    /// The wrench within force, torque and their slopes; what is not a number counts as nothing.
    pub fn bounded(&mut self, wanted: &Wrench, dt: f64) -> Wrench {
        let wanted = if wanted.is_finite() { *wanted } else { Wrench::ZERO };
        let wanted = wanted.clamped(self.limits.force_n, self.limits.torque_nm);
        let change = (wanted - self.last).clamped(self.limits.slew_n_s * dt, self.limits.slew_nm_s * dt);
        self.last += change;
        self.last
    }

    /// Begins anew after a break.
    pub fn rest(&mut self) {
        self.last = Wrench::ZERO;
    }
}

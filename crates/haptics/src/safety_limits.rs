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
    given: f64,
}

impl SafetyLimits {
    /// Begins at rest.
    pub fn new(limits: Limits) -> Self {
        Self { limits, last: Wrench::ZERO, given: 0.0 }
    }

    /// As much of a wrench as the energy of the last second allows; `dt` is a step [s].
    pub fn within_energy(&mut self, wanted: &Wrench, twist: &Twist, dt: f64) -> Wrench {
        self.given *= libm::exp(-dt / WINDOW_S);
        let power = wanted.power(twist);
        if power <= 0.0 || !power.is_finite() {
            return *wanted;
        }
        let left = (self.limits.energy_j - self.given).max(0.0);
        let share = (left / (power * dt)).min(1.0);
        self.given += power * dt * share;
        *wanted * share
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

//! Safety limits: force, torque, their slew rates, and energy per second.

use crate::device::Limits;
use crate::wrench::{Twist, Wrench};

/// Time constant of the energy budget [s] (the limits are stated per second).
const WINDOW_S: f64 = 1.0;

/// Bounds every wrench, whatever its origin.
#[derive(Clone, Copy, Debug)]
pub struct SafetyLimits {
    limits: Limits,
    last: Wrench,
    /// Energy given to the hand, decaying with the time constant of the budget [J].
    given: f64,
}

impl SafetyLimits {
    /// Creates limits for a device at rest.
    pub fn new(limits: Limits) -> Self {
        Self { limits, last: Wrench::ZERO, given: 0.0 }
    }

    /// Charges the energy that the last step of `dt` [s] gave to the hand, `spent` [J].
    ///
    /// `back` [J] is energy that virtual bodies return after the hand had put it into them; it does not count.
    pub fn charge(&mut self, spent: f64, back: f64, dt: f64) {
        let own = if back.is_finite() { back.max(0.0) } else { 0.0 };
        // An unknown energy counts as the whole budget.
        let counts = if spent.is_finite() { (spent - own).max(0.0) } else { self.limits.energy_j };
        self.given = self.given * libm::exp(-dt / WINDOW_S) + counts;
    }

    /// Returns a wrench scaled to the remaining energy budget over a step of `dt` [s] [N, N·m].
    pub fn within_energy(&self, wanted: &Wrench, twist: &Twist, dt: f64) -> Wrench {
        let power = wanted.power(twist);
        if power <= 0.0 || !power.is_finite() {
            return *wanted;
        }
        let left = (self.limits.energy_j - self.given).max(0.0);
        *wanted * (left / (power * dt)).min(1.0)
    }

    /// Returns a wrench within the limits of force, torque and slew rate [N, N·m]; a wrench that is not finite counts as zero.
    pub fn bounded(&mut self, wanted: &Wrench, dt: f64) -> Wrench {
        let wanted = if wanted.is_finite() { *wanted } else { Wrench::ZERO };
        let wanted = wanted.clamped(self.limits.force_n, self.limits.torque_nm);
        let change = (wanted - self.last).clamped(self.limits.slew_n_s * dt, self.limits.slew_nm_s * dt);
        self.last += change;
        self.last
    }

    /// Restarts the slew rate limit from zero.
    pub fn rest(&mut self) {
        self.last = Wrench::ZERO;
    }
}

//! Sees to it that the loop never gives more energy than it got.

use crate::wrench::{Twist, Wrench};

/// Metres that a radian counts as, where both are damped at once [m] (chosen: a pan's radius).
const LEVER: f64 = 0.1;
/// The account never holds more than this many reserves beyond what the felt bodies hold (chosen: old dissipation must not
/// pay for later activity).
const FULLEST: f64 = 20.0;
/// Share of the reserve below which the controller acts [-] (chosen: what a step's change of speed can cost is less).
const FLOOR: f64 = 0.2;

/// Shortest time in which the account above its floor may be spent [s] (chosen: so slowly does 25 N fade that no device's
/// limit of change, 5 N a millisecond, keeps a force up that the account can no longer pay).
const SPENDING_S: f64 = 0.01;
/// Time in which the account comes back to its floor [s] (chosen), and the most damping that this may take [N·s/m] (chosen: less
/// than an arm's own).
const RECOVERY_S: f64 = 0.05;
const RECOVERY_DAMPING: f64 = 5.0;

/// Passivity observer and controller in the time domain (Hannaford & Ryu 2002).
///
/// The observer's account is E ← E − w·ẋ Δt [J] over all that the hand feels but weights, whose work the height of the contents
/// gives back. What the hand has put into a body that it moves is due back to it: the account may hold that body's kinetic and
/// spring energy beside the reserve. Power is at most P = (E − E_floor)/τ, so that the account nears a fifth of the reserve without
/// passing it and forces fade no faster than the device's limits of change let them; where more is wanted, the controller adds damping
/// α = (w·ẋ − P)/|ẋ|²; an account below
/// that floor is filled up by a little damping more. Where the device does not take so much damping, the wrench itself is lessened, and
/// grows again within 50 ms: a light grip would otherwise be shaken by it.
#[derive(Clone, Copy, Debug)]
pub struct Passivity {
    account: f64,
    reserve: f64,
    most_damping: f64,
    gain: f64,
    lowest: f64,
    last: Wrench,
}

impl Passivity {
    /// Begins with a reserve [J]; no more damping is added than the device takes [N·s/m].
    pub fn new(reserve: f64, most_damping: f64) -> Self {
        Self { account: reserve, reserve, most_damping, gain: 1.0, lowest: reserve, last: Wrench::ZERO }
    }

    /// Energy that comes from elsewhere, as that of food that lands [J].
    pub fn credit(&mut self, energy: f64) {
        self.account = (self.account + energy.max(0.0)).min(self.account.max(FULLEST * self.reserve));
    }

    /// Settles what the last wrench did with the speed that has just been measured; `dt` is a step [s], `held` what the
    /// felt bodies hold of what the hand gave [J].
    pub fn observe(&mut self, twist: &Twist, held: f64, dt: f64) {
        self.account = (self.account - self.last.power(twist) * dt).min(FULLEST * self.reserve + held);
        self.lowest = self.lowest.min(self.account);
    }

    /// The wrench to show instead of `wanted`.
    pub fn control(&mut self, wanted: &Wrench, twist: &Twist, dt: f64) -> Wrench {
        let speed = twist.linear.length_squared() + LEVER * LEVER * twist.angular.length_squared();
        let left = self.account - FLOOR * self.reserve;
        let allowed =
            if left > 0.0 { left / SPENDING_S.max(dt) } else { (left / RECOVERY_S).max(-RECOVERY_DAMPING * speed) };
        self.gain = (self.gain + dt / RECOVERY_S).min(1.0);
        let power = wanted.power(twist);
        if power > 0.0 {
            self.gain = self.gain.min(((allowed + self.most_damping * speed) / power).clamp(0.0, 1.0));
        }
        let scaled = *wanted * self.gain;
        let excess = scaled.power(twist) - allowed;
        if excess <= 0.0 || speed <= 0.0 {
            return scaled;
        }
        let alpha = (excess / speed).min(self.most_damping);
        scaled + Wrench { force: twist.linear * -alpha, torque: twist.angular * (-alpha * LEVER * LEVER) }
    }

    /// Notes what is really shown until the next step, weights left out.
    pub fn shown(&mut self, wrench: &Wrench) {
        self.last = *wrench;
    }

    /// The account now [J].
    pub fn account(&self) -> f64 {
        self.account
    }

    /// The lowest value of the account so far [J].
    pub fn lowest(&self) -> f64 {
        self.lowest
    }
}

//! Sees to it that the loop never gives more energy than it got.

use saute_kitchen::dynamics::Pose;
use saute_kitchen::dynamics::pose::rotation_between;

use crate::wrench::{Twist, Wrench};

/// Metres that a radian counts as, where both are damped at once [m] (chosen: a pan's radius).
const LEVER: f64 = 0.1;
/// The account never holds more than this many reserves beyond what the felt bodies hold (chosen: a tenth of a joule, what a spoon
/// that falls 20 cm has; dissipation older than that must not pay for later activity).
const FULLEST: f64 = 20.0;
/// Share of the reserve that is left alone [-] (chosen: what forces cost while they fade and a device's samples are on their way;
/// the rest is spent).
const FLOOR: f64 = 0.5;

/// Shortest time in which the account above its floor may be spent [s] (chosen: so slowly does 25 N fade that no device's
/// limit of change, 5 N a millisecond, and no sample that is 3 ms old keep a force up that the account can no longer pay).
const SPENDING_S: f64 = 0.02;
/// Time in which the account comes back to its floor [s] (chosen: shorter than a beat of vibration that a hand counts), and the
/// most damping that this may take [N·s/m] (chosen: less than an arm's own).
const RECOVERY_S: f64 = 0.05;
const RECOVERY_DAMPING: f64 = 5.0;
/// Time over which displacements are smoothed to a velocity [s] (chosen: two samples; a device's own filter takes twice as long).
const MOVING_S: f64 = 0.002;

/// Passivity observer and controller in the time domain (Hannaford & Ryu 2002).
///
/// The observer's account is E ← E − w·Δx [J] over all that the hand feels but weights, whose work the height of the contents
/// gives back; Δx is how far the pan went and turned while w was held, which is exact where a filtered velocity would make a late
/// spring look dissipative. One account is kept of what was asked for and one of what the device says it made; the lower one
/// counts. (The worse of the two in every step would charge a wall that the device is too weak for, at every touch, with what no
/// device did.)
///
/// The account begins with one reserve and may hold up to twenty: so much earlier dissipation may be spent again. What the hand has
/// put into a body that it moves is due back to it: the account may hold that body's kinetic and spring energy beside the twenty.
/// Power is at most P = (E − E_floor)/τ, so that the account nears half the reserve without passing it and forces fade no
/// faster than the device's limits of change let them; where more is wanted, the controller adds damping α = (w·ẋ − P)/|ẋ|²; an
/// account below that floor is filled up by a little damping more. Where the device does not take so much damping, the wrench
/// itself is lessened, and grows again within 50 ms: a light grip would otherwise be shaken by it.
#[derive(Clone, Copy, Debug)]
pub struct Passivity {
    /// By what was asked for, and by what the device says it made [J].
    accounts: [f64; 2],
    reserve: f64,
    most_damping: f64,
    gain: f64,
    lowest: f64,
    last: Wrench,
    weight: Wrench,
    before: Option<Pose>,
    moving: Twist,
    /// What the device made beyond what it was asked for.
    off: Wrench,
}

impl Passivity {
    /// Begins with a reserve [J]; no more damping is added than the device takes [N·s/m].
    pub fn new(reserve: f64, most_damping: f64) -> Self {
        Self {
            accounts: [reserve; 2],
            reserve,
            most_damping,
            gain: 1.0,
            lowest: reserve,
            last: Wrench::ZERO,
            weight: Wrench::ZERO,
            before: None,
            moving: Twist::default(),
            off: Wrench::ZERO,
        }
    }

    /// Energy that comes from elsewhere, as that of food that lands [J].
    pub fn credit(&mut self, energy: f64) {
        for account in &mut self.accounts {
            *account = (*account + energy.max(0.0)).min(account.max(FULLEST * self.reserve));
        }
    }

    /// Settles what the last wrench did on the way to where the pan has just been found, and gives it, or what was made instead where
    /// that is more [J]; `made` is what the device says it made, weights included, `held` what the felt bodies hold of what the
    /// hand gave [J], `dt` a step [s].
    pub fn observe(&mut self, pose: &Pose, made: &Wrench, held: f64, dt: f64) -> f64 {
        let way = self.way(pose, dt);
        // A device that tells nothing of what it made tells exactly nothing.
        self.off = if *made == Wrench::ZERO { Wrench::ZERO } else { *made - self.weight - self.last };
        let asked = self.last.power(&way);
        let spent = [asked, asked + self.off.power(&way)];
        let most = FULLEST * self.reserve + if held.is_finite() { held.max(0.0) } else { 0.0 };
        for (account, spent) in self.accounts.iter_mut().zip(spent) {
            *account = if spent.is_finite() { (*account - spent).min(most) } else { account.min(FLOOR * self.reserve) };
        }
        self.lowest = self.lowest.min(self.account());
        asked + positive(spent[1] - asked)
    }

    /// How far the pan went and turned since it was found last [m, rad].
    fn way(&mut self, pose: &Pose, dt: f64) -> Twist {
        let before = self.before.replace(*pose).unwrap_or(*pose);
        let (linear, angular) = (pose.position - before.position, rotation_between(before.rotation, pose.rotation));
        if dt > 0.0 && linear.is_finite() && angular.is_finite() {
            let share = 1.0 - libm::exp(-dt / MOVING_S);
            self.moving.linear += (linear / dt - self.moving.linear) * share;
            self.moving.angular += (angular / dt - self.moving.angular) * share;
        }
        Twist { linear, angular }
    }

    /// Power of a wrench [W], and of what the device will make beyond it as it just did: the larger of what its velocity and what
    /// the last displacements say.
    fn power(&self, wrench: &Wrench, twist: &Twist) -> f64 {
        let by = |twist: &Twist| wrench.power(twist) + positive(self.off.power(twist));
        by(twist).max(by(&self.moving))
    }

    /// The wrench to show instead of `wanted`; damping is against `twist`.
    pub fn control(&mut self, wanted: &Wrench, twist: &Twist, dt: f64) -> Wrench {
        let speed = twist.linear.length_squared() + LEVER * LEVER * twist.angular.length_squared();
        let floor = FLOOR * self.reserve;
        let left = self.account() - floor;
        let allowed =
            if left > 0.0 { left / SPENDING_S.max(dt) } else { (left / RECOVERY_S).max(-RECOVERY_DAMPING * speed) };
        self.gain = (self.gain + dt / RECOVERY_S).min(1.0);
        let power = self.power(wanted, twist);
        if power > 0.0 {
            // Damping comes late: near the floor nothing is shown that only damping would pay for.
            let damped = self.most_damping * speed * (left / floor.max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
            self.gain = self.gain.min(((allowed + damped) / power).clamp(0.0, 1.0));
        }
        let scaled = *wanted * self.gain;
        let excess = self.power(&scaled, twist) - allowed;
        if excess <= 0.0 || speed <= 0.0 {
            return scaled;
        }
        let alpha = (excess / speed).min(self.most_damping);
        scaled + Wrench { force: twist.linear * -alpha, torque: twist.angular * (-alpha * LEVER * LEVER) }
    }

    /// Notes what is really shown until the next step, weights left out, and which weights are shown beside it.
    pub fn shown(&mut self, wrench: &Wrench, weight: &Wrench) {
        let finite = |w: &Wrench| if w.is_finite() { *w } else { Wrench::ZERO };
        (self.last, self.weight) = (finite(wrench), finite(weight));
    }

    /// Nothing is shown, and where the pan goes meanwhile costs nothing.
    pub fn rest(&mut self) {
        (self.last, self.weight) = (Wrench::ZERO, Wrench::ZERO);
        (self.before, self.moving, self.off) = (None, Twist::default(), Wrench::ZERO);
    }

    /// The account now, the lower of the two [J].
    pub fn account(&self) -> f64 {
        self.accounts[0].min(self.accounts[1])
    }

    /// The lowest value of the account so far [J].
    pub fn lowest(&self) -> f64 {
        self.lowest
    }
}

/// A work or power that is charged but never credited; what is not a number stays so.
fn positive(energy: f64) -> f64 {
    if energy < 0.0 { 0.0 } else { energy }
}

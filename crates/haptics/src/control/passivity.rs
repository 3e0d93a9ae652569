//! Time-domain passivity: an observer of the energy that the loop gives, and a controller that limits it.

use saute_kitchen::dynamics::Pose;
use saute_kitchen::dynamics::pose::rotation_between;

use crate::wrench::{Twist, Wrench};

/// Lever that converts rotation to displacement where both are damped together [m] (chosen: a pan's radius).
const LEVER: f64 = 0.1;
/// Upper limit of the account, in reserves above the energy of the virtual bodies [-] (chosen: a tenth of a joule, the energy of a
/// spoon after a fall of 20 cm; older dissipation must not pay for later activity).
const FULLEST: f64 = 20.0;
/// Share of the reserve that is never spent [-] (chosen: it covers fading forces and the latency of the device's samples).
const FLOOR: f64 = 0.5;

/// Shortest time in which the account above its floor may be spent [s] (chosen: 25 N then fade slowly enough for a device's slew
/// rate of 5 N/ms and a sample latency of 3 ms).
const SPENDING_S: f64 = 0.02;
/// Time in which the account recovers to its floor [s] (chosen: shorter than a vibration period that a hand can count).
const RECOVERY_S: f64 = 0.05;
/// Greatest damping for that recovery [N·s/m] (chosen: less than an arm's own).
const RECOVERY_DAMPING: f64 = 5.0;
/// Time constant of the velocity from displacements [s] (chosen: two samples; a device's own filter takes twice as long).
const MOVING_S: f64 = 0.002;

/// Passivity observer and controller in the time domain (Hannaford & Ryu 2002 `[@hannaford-ryu-2002]`).
///
/// The observer integrates force × displacement: E ← E − w·Δx [J], over everything that the hand feels except weights, whose
/// work the height of the contents returns. Δx is the displacement and rotation of the pan while w was held. That is exact;
/// a filtered velocity would make a late spring look dissipative. Two accounts are kept, one with the commanded and one with
/// the reported wrench, and the lower value is used. (Charging the worse of the two in every step would charge a wall that the
/// device is too weak for at every contact, although no device did that work.)
///
/// The account starts with one reserve and contains at most twenty, so that much earlier dissipation may be spent again. Energy
/// that the hand has put into a virtual body is due back to it: the account may hold the body's kinetic and spring energy in
/// addition. The power is at most P = (E − E_floor)/τ: the account approaches half the reserve without passing it, and forces
/// fade no faster than the device's slew rate. Where more power is requested, the controller adds the damping
/// α = (w·ẋ − P)/|ẋ|². An account below its floor is refilled by a little more damping. Where the device does not render that
/// much damping, the wrench itself is scaled down, and recovers within 50 ms; otherwise a light grip would be shaken.
#[derive(Clone, Copy, Debug)]
pub struct Passivity {
    /// Energy by the commanded wrench, and by the wrench that the device reports [J].
    accounts: [f64; 2],
    reserve: f64,
    most_damping: f64,
    gain: f64,
    lowest: f64,
    last: Wrench,
    weight: Wrench,
    before: Option<Pose>,
    /// Velocity from displacements [m/s, rad/s].
    moving: Twist,
    /// Reported minus commanded wrench [N, N·m].
    off: Wrench,
}

impl Passivity {
    /// Creates accounts with a reserve [J]; the controller adds at most `most_damping` [N·s/m].
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

    /// Credits energy from the kitchen, such as that of landing food [J].
    pub fn credit(&mut self, energy: f64) {
        for account in &mut self.accounts {
            *account = (*account + energy.max(0.0)).min(account.max(FULLEST * self.reserve));
        }
    }

    /// Charges the work of the last wrench over the displacement to `pose`, and returns the larger of commanded and reported work [J].
    ///
    /// `reported` is the wrench that the device reports, weights included [N, N·m]. `held` is the energy that the hand has put
    /// into virtual bodies [J], `dt` the step [s].
    pub fn observe(&mut self, pose: &Pose, reported: &Wrench, held: f64, dt: f64) -> f64 {
        let way = self.displacement(pose, dt);
        // A device that reports no wrench reports exactly zero.
        self.off = if *reported == Wrench::ZERO { Wrench::ZERO } else { *reported - self.weight - self.last };
        let commanded = self.last.power(&way);
        let spent = [commanded, commanded + self.off.power(&way)];
        let most = FULLEST * self.reserve + if held.is_finite() { held.max(0.0) } else { 0.0 };
        for (account, spent) in self.accounts.iter_mut().zip(spent) {
            *account = if spent.is_finite() { (*account - spent).min(most) } else { account.min(FLOOR * self.reserve) };
        }
        self.lowest = self.lowest.min(self.account());
        commanded + positive(spent[1] - commanded)
    }

    /// Returns displacement and rotation of the pan since the last step [m, rad].
    fn displacement(&mut self, pose: &Pose, dt: f64) -> Twist {
        let before = self.before.replace(*pose).unwrap_or(*pose);
        let (linear, angular) = (pose.position - before.position, rotation_between(before.rotation, pose.rotation));
        if dt > 0.0 && linear.is_finite() && angular.is_finite() {
            let share = 1.0 - libm::exp(-dt / MOVING_S);
            self.moving.linear += (linear / dt - self.moving.linear) * share;
            self.moving.angular += (angular / dt - self.moving.angular) * share;
        }
        Twist { linear, angular }
    }

    /// Returns the power of a wrench plus the device's last excess wrench [W].
    ///
    /// It uses the larger value of the reported velocity and the velocity from displacements.
    fn power(&self, wrench: &Wrench, twist: &Twist) -> f64 {
        let by = |twist: &Twist| wrench.power(twist) + positive(self.off.power(twist));
        by(twist).max(by(&self.moving))
    }

    /// Returns a passive wrench instead of `wanted` [N, N·m]; damping opposes `twist`.
    pub fn control(&mut self, wanted: &Wrench, twist: &Twist, dt: f64) -> Wrench {
        let speed = twist.linear.length_squared() + LEVER * LEVER * twist.angular.length_squared();
        let floor = FLOOR * self.reserve;
        let left = self.account() - floor;
        let allowed =
            if left > 0.0 { left / SPENDING_S.max(dt) } else { (left / RECOVERY_S).max(-RECOVERY_DAMPING * speed) };
        self.gain = (self.gain + dt / RECOVERY_S).min(1.0);
        let power = self.power(wanted, twist);
        if power > 0.0 {
            // Damping acts with a delay: near the floor no power is rendered that only damping would pay for.
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

    /// Records the rendered wrench without weights, and the rendered weights, which both hold until the next step [N, N·m].
    pub fn shown(&mut self, wrench: &Wrench, weight: &Wrench) {
        let finite = |w: &Wrench| if w.is_finite() { *w } else { Wrench::ZERO };
        (self.last, self.weight) = (finite(wrench), finite(weight));
    }

    /// Records that nothing is rendered: displacements cost nothing until the next `shown`.
    pub fn rest(&mut self) {
        (self.last, self.weight) = (Wrench::ZERO, Wrench::ZERO);
        (self.before, self.moving, self.off) = (None, Twist::default(), Wrench::ZERO);
    }

    /// Returns the lower of the two accounts [J].
    pub fn account(&self) -> f64 {
        self.accounts[0].min(self.accounts[1])
    }

    /// Returns true if the account is below minus one reserve: more energy was given than a sound device can have had.
    pub fn is_overdrawn(&self) -> bool {
        self.account() < -self.reserve
    }

    /// Restarts both accounts from one reserve; the lowest value so far stays.
    pub fn restart(&mut self) {
        self.rest();
        (self.accounts, self.gain) = ([self.reserve; 2], 1.0);
    }

    /// Returns the lowest value of the account so far [J]; it is the full reserve, and gives no information, while the device has not moved.
    pub fn lowest(&self) -> f64 {
        self.lowest
    }
}

/// Returns a work or power that is charged but never credited; NaN stays NaN.
fn positive(energy: f64) -> f64 {
    if energy < 0.0 { 0.0 } else { energy }
}

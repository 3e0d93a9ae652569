//! A pan that no hand holds any more is set down on its ring, gently.

use saute_kitchen::dynamics::Pose;
use saute_kitchen::dynamics::pose::{about, rotation_between};
use saute_kitchen::{Command, Kitchen};

/// How fast the pan is set down at most [m/s] (chosen: a calm arm), and the least time that it takes [s] (chosen: food stays where it is).
const SPEED: f64 = 0.15;
const LEAST_S: f64 = 0.8;
/// Steepest part of the way over its mean: of 3s² − 2s³ [-].
const STEEPEST: f64 = 1.5;

/// The way from where the hand let go to the ring of the hob, x = x₀ + (3s² − 2s³)(x₁ − x₀) with s = t/T.
#[derive(Clone, Copy, Debug)]
pub struct LayDown {
    from: Pose,
    told: Pose,
    since: f64,
}

impl LayDown {
    /// From where the kitchen's pan is held now.
    pub fn begin(kitchen: &Kitchen) -> Self {
        let from = kitchen.held_pan();
        Self { from, told: from, since: 0.0 }
    }

    /// Goes on by `dt` [s]; tells whether it is done, or another hand has taken the pan.
    pub fn step(&mut self, kitchen: &mut Kitchen, dt: f64) -> bool {
        if kitchen.held_pan() != self.told {
            return true;
        }
        let ring = kitchen.world().pan_shape().standing([0.0, 0.0], 0.0, Pose::default().rotation);
        let way = ring.position - self.from.position;
        let takes = (STEEPEST * way.length() / SPEED).max(LEAST_S);
        self.since += dt;
        let s = (self.since / takes).min(1.0);
        let share = s * s * (3.0 - 2.0 * s);
        let turn = rotation_between(self.from.rotation, ring.rotation);
        let pose = Pose {
            position: self.from.position + way * share,
            rotation: (about(turn * share) * self.from.rotation).normalize(),
        };
        // Refused only for poses that are no numbers.
        let _ = kitchen.apply(&Command::HoldPan { pose });
        self.told = kitchen.held_pan();
        s >= 1.0
    }
}

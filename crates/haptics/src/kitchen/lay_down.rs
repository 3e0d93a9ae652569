//! Lay down: a released pan returns gently to its ring on the hob.

use saute_kitchen::dynamics::Pose;
use saute_kitchen::dynamics::pose::{about, rotation_between};
use saute_kitchen::{Command, Kitchen};

/// Maximum speed of the pan [m/s] (chosen: a calm arm).
const SPEED: f64 = 0.15;
/// Minimum duration [s] (chosen: food stays in its place).
const LEAST_S: f64 = 0.8;
/// Peak over mean speed of the smoothstep 3s² − 2s³ [-].
const STEEPEST: f64 = 1.5;

/// Motion from the release pose to the ring: x = x₀ + (3s² − 2s³)(x₁ − x₀) with s = t/T.
#[derive(Clone, Copy, Debug)]
pub struct LayDown {
    from: Pose,
    commanded: Pose,
    since: f64,
}

impl LayDown {
    /// Creates the motion from the pose that the kitchen's pan has now.
    pub fn begin(kitchen: &Kitchen) -> Self {
        let from = kitchen.held_pan();
        Self { from, commanded: from, since: 0.0 }
    }

    /// Advances by `dt` [s]; returns true at the end, or once another hand has taken the pan.
    pub fn step(&mut self, kitchen: &mut Kitchen, dt: f64) -> bool {
        if kitchen.held_pan() != self.commanded {
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
        // Only poses that are not finite are refused.
        let _ = kitchen.apply(&Command::HoldPan { pose });
        self.commanded = kitchen.held_pan();
        s >= 1.0
    }
}

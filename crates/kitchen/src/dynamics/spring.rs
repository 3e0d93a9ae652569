//! The spring–damper by which a hand holds a body: critically damped, relative to the moving target.

use glam::DVec3;
use serde::{Deserialize, Serialize};

use super::pose::{Pose, rotation_between};
use super::world::RIGID_S;

/// Natural frequency [rad/s] (chosen: 4 mm of sag without compensation of the weight).
const STIFF: f64 = 50.0;

/// A spring–damper between the target pose of a body and its pose.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Serialize)]
pub struct Spring {
    /// Target pose in the last step.
    wanted: Pose,
}

impl Spring {
    /// A spring at rest.
    pub fn at(wanted: Pose) -> Self {
        Self { wanted }
    }

    /// Acceleration [m/s²] and angular acceleration [rad/s²] of a body towards its target, one step after the last call.
    ///
    /// a = ω² x − 2ω (v − v_target); the damping acts on the velocity relative to the target.
    pub fn pull(&mut self, wanted: &Pose, body: &Pose, [velocity, turning]: [DVec3; 2]) -> [DVec3; 2] {
        let led = (wanted.position - self.wanted.position) / RIGID_S;
        let spun = rotation_between(self.wanted.rotation, wanted.rotation) / RIGID_S;
        self.wanted = *wanted;
        let (off, twist) = (wanted.position - body.position, rotation_between(body.rotation, wanted.rotation));
        let towards = |off: DVec3, rate: DVec3| STIFF * STIFF * off - 2.0 * STIFF * rate;
        [towards(off, velocity - led), towards(twist, turning - spun)]
    }
}

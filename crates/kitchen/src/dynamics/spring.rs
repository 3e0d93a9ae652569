//! How a hand holds a body: by a critically damped spring that moves along with what is led.

use glam::DVec3;

use super::pose::{Pose, rotation_between};
use super::world::RIGID_S;

/// Natural frequency [rad/s] (chosen: food hangs 4 mm low without the weight's compensation).
const STIFF: f64 = 50.0;

/// A spring between where a hand wants a body and where that is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spring {
    /// Where the body was wanted in the last step.
    wanted: Pose,
}

impl Spring {
    /// A spring at rest.
    pub fn at(wanted: Pose) -> Self {
        Self { wanted }
    }

    /// What pulls a body towards where it is wanted now, a step later: acceleration [m/s²] and that of turning [rad/s²].
    ///
    /// a = ω² x − 2ω (v − v_led); what is led moves along with the hand, the spring only mends what is left.
    pub fn pull(&mut self, wanted: &Pose, body: &Pose, [velocity, turning]: [DVec3; 2]) -> [DVec3; 2] {
        let led = (wanted.position - self.wanted.position) / RIGID_S;
        let spun = rotation_between(self.wanted.rotation, wanted.rotation) / RIGID_S;
        self.wanted = *wanted;
        let (off, twist) = (wanted.position - body.position, rotation_between(body.rotation, wanted.rotation));
        let towards = |off: DVec3, rate: DVec3| STIFF * STIFF * off - 2.0 * STIFF * rate;
        [towards(off, velocity - led), towards(twist, turning - spun)]
    }
}

//! Eight strings between motors and a body: their lengths at a pose, and what their tensions do to the body.

use glam::DVec3;
use saute_kitchen::dynamics::Pose;

use crate::wrench::Wrench;

/// Strings of a device.
pub const STRINGS: usize = 8;

/// Where strings leave their motors and where they are fixed to the body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StringRig {
    /// Where each string leaves its motor, in the kitchen [m].
    pub motor: [DVec3; STRINGS],
    /// Where each string is fixed, in the body's frame [m].
    pub attachment: [DVec3; STRINGS],
}

/// Straight strings at one pose.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lines {
    /// Distance from attachment to motor [m].
    pub length: [f64; STRINGS],
    /// From attachment to motor [-].
    pub direction: [DVec3; STRINGS],
    /// Torque about the body's origin of a unit tension [m].
    pub lever: [DVec3; STRINGS],
}

impl StringRig {
    /// The strings at a pose of the body.
    pub fn lines(&self, pose: &Pose) -> Lines {
        let mut lines = Lines { length: [0.0; STRINGS], direction: [DVec3::Z; STRINGS], lever: [DVec3::ZERO; STRINGS] };
        for i in 0..STRINGS {
            let arm = pose.rotation * self.attachment[i];
            let way = self.motor[i] - (pose.position + arm);
            lines.length[i] = way.length();
            lines.direction[i] = way / lines.length[i].max(1e-9);
            lines.lever[i] = arm.cross(lines.direction[i]);
        }
        lines
    }

    /// Whether each string begins and ends within a distance of where another rig's does [m].
    pub fn is_near(&self, other: &Self, distance: f64) -> bool {
        let ends = |rig: &Self| rig.motor.into_iter().chain(rig.attachment);
        ends(self).zip(ends(other)).all(|(a, b)| (a - b).length() <= distance)
    }

    /// Lengths at a pose [m].
    pub fn lengths(&self, pose: &Pose) -> [f64; STRINGS] {
        self.lines(pose).length
    }
}

impl Lines {
    /// What tensions do to the body [N, N·m].
    pub fn wrench(&self, tensions: &[f64; STRINGS]) -> Wrench {
        let mut sum = Wrench::ZERO;
        for (i, t) in tensions.iter().enumerate() {
            sum += Wrench { force: self.direction[i] * *t, torque: self.lever[i] * *t };
        }
        sum
    }

    /// Force and torque of a unit tension in one string [-, m].
    pub fn column(&self, string: usize) -> [f64; 6] {
        Wrench { force: self.direction[string], torque: self.lever[string] }.rows()
    }
}

//! Eight strings between motors and a body: lengths at a pose, and the wrench of the tensions.

use glam::DVec3;
use saute_kitchen::dynamics::Pose;

use crate::wrench::Wrench;

/// Number of strings of a device.
pub const STRINGS: usize = 8;

/// End points of the strings.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StringRig {
    /// Motor end of each string, in the kitchen [m].
    pub motor: [DVec3; STRINGS],
    /// Body end of each string, in the body's frame [m].
    pub attachment: [DVec3; STRINGS],
}

/// Straight strings at one pose.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lines {
    /// Length from attachment to motor [m].
    pub length: [f64; STRINGS],
    /// Unit direction from attachment to motor [-].
    pub direction: [DVec3; STRINGS],
    /// Torque about the body's origin per unit tension [m].
    pub lever: [DVec3; STRINGS],
}

impl StringRig {
    /// Returns the strings at a pose of the body.
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

    /// Returns true if all end points are within `distance` of those of another rig [m].
    pub fn is_near(&self, other: &Self, distance: f64) -> bool {
        let ends = |rig: &Self| rig.motor.into_iter().chain(rig.attachment);
        ends(self).zip(ends(other)).all(|(a, b)| (a - b).length() <= distance)
    }

    /// Returns the string lengths at a pose [m].
    pub fn lengths(&self, pose: &Pose) -> [f64; STRINGS] {
        self.lines(pose).length
    }
}

impl Lines {
    /// Returns the wrench of the tensions on the body [N, N·m].
    pub fn wrench(&self, tensions: &[f64; STRINGS]) -> Wrench {
        let mut sum = Wrench::ZERO;
        for (i, t) in tensions.iter().enumerate() {
            sum += Wrench { force: self.direction[i] * *t, torque: self.lever[i] * *t };
        }
        sum
    }

    /// Returns force and torque per unit tension of one string, a column of the structure matrix [-, m].
    pub fn column(&self, string: usize) -> [f64; 6] {
        Wrench { force: self.direction[string], torque: self.lever[string] }.rows()
    }
}

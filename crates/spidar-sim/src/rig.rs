//! The simulated device's real string geometry, with manufacturing errors.

use glam::{DQuat, DVec3};

use crate::random::Random;
use crate::rig_file::RigFile;

/// Position and orientation of the pan.
#[derive(Clone, Copy, Debug)]
pub struct Pose {
    pub position: DVec3,
    pub rotation: DQuat,
}

/// Real end points of the strings.
#[derive(Clone, Copy, Debug)]
pub struct Rig {
    motor: [DVec3; 8],
    attachment: [DVec3; 8],
}

impl Rig {
    /// Creates a rig as drawn, with a random error of each coordinate [m].
    pub fn built(file: &RigFile, error: f64, random: &mut Random) -> Self {
        let mut off = |mm: [f64; 3]| {
            DVec3::from_array(mm) * 1e-3 + DVec3::new(random.signed(), random.signed(), random.signed()) * error
        };
        Self { motor: file.strings.motor_mm.map(&mut off), attachment: file.strings.attachment_mm.map(&mut off) }
    }

    /// Returns the vector from attachment to motor [m].
    pub fn string(&self, i: usize, pose: &Pose) -> DVec3 {
        self.motor[i] - pose.position - pose.rotation * self.attachment[i]
    }

    /// Returns force and torque of one tension about the pan's origin [N, N·m].
    pub fn pull(&self, i: usize, pose: &Pose, tension: f64) -> (DVec3, DVec3) {
        let force = self.string(i, pose).normalize_or_zero() * tension;
        (force, (pose.rotation * self.attachment[i]).cross(force))
    }
}

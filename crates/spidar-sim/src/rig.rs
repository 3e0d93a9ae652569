//! Where the strings of this one device really begin and end.

use glam::{DQuat, DVec3};

use crate::random::Random;
use crate::rig_file::RigFile;

/// Place and orientation of the pan.
#[derive(Clone, Copy, Debug)]
pub struct Pose {
    pub position: DVec3,
    pub rotation: DQuat,
}

/// A device as it was really built.
#[derive(Clone, Copy, Debug)]
pub struct Rig {
    motor: [DVec3; 8],
    attachment: [DVec3; 8],
}

impl Rig {
    /// As drawn, but for an error of each coordinate [m].
    pub fn built(file: &RigFile, error: f64, random: &mut Random) -> Self {
        let mut off = |mm: [f64; 3]| {
            DVec3::from_array(mm) * 1e-3 + DVec3::new(random.signed(), random.signed(), random.signed()) * error
        };
        Self { motor: file.strings.motor_mm.map(&mut off), attachment: file.strings.attachment_mm.map(&mut off) }
    }

    /// From the attachment to the motor [m].
    pub fn string(&self, i: usize, pose: &Pose) -> DVec3 {
        self.motor[i] - pose.position - pose.rotation * self.attachment[i]
    }

    /// Force and torque about the pan's origin of one tension [N, N·m].
    pub fn pull(&self, i: usize, pose: &Pose, tension: f64) -> (DVec3, DVec3) {
        let force = self.string(i, pose).normalize_or_zero() * tension;
        (force, (pose.rotation * self.attachment[i]).cross(force))
    }
}

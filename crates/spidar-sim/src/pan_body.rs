//! The rigid pan, moved by strings and hand.

use glam::{DQuat, DVec3};

use crate::rig::Pose;

/// Radius of gyration [m] (chosen: a 26 cm pan without handle).
const GYRATION: f64 = 0.085;

/// State of the pan.
#[derive(Clone, Copy, Debug)]
pub struct PanBody {
    pub pose: Pose,
    pub velocity: DVec3,
    pub turning: DVec3,
    mass: f64,
}

impl PanBody {
    /// Creates a pan at rest.
    pub fn new(mass: f64, pose: Pose) -> Self {
        Self { pose, velocity: DVec3::ZERO, turning: DVec3::ZERO, mass }
    }

    /// Advances by `dt` [s] under a force and a torque about its centre [N, N·m].
    pub fn step(&mut self, force: DVec3, torque: DVec3, dt: f64) {
        self.velocity += force * (dt / self.mass);
        self.turning += torque * (dt / (self.mass * GYRATION * GYRATION));
        self.pose.position += self.velocity * dt;
        self.pose.rotation = (DQuat::from_scaled_axis(self.turning * dt) * self.pose.rotation).normalize();
    }
}

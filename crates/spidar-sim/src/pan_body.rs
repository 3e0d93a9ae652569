//! A rigid pan that strings and a hand pull.

use glam::{DQuat, DVec3};

use crate::rig::Pose;

/// Radius of gyration [m] (chosen: a 26 cm pan without handle).
const GYRATION: f64 = 0.085;

/// A moving pan.
#[derive(Clone, Copy, Debug)]
pub struct PanBody {
    pub pose: Pose,
    pub velocity: DVec3,
    pub turning: DVec3,
    mass: f64,
}

impl PanBody {
    /// At rest.
    pub fn new(mass: f64, pose: Pose) -> Self {
        Self { pose, velocity: DVec3::ZERO, turning: DVec3::ZERO, mass }
    }

    /// One step of `dt` [s] under a force and a torque about its middle [N, N·m].
    pub fn step(&mut self, force: DVec3, torque: DVec3, dt: f64) {
        self.velocity += force * (dt / self.mass);
        self.turning += torque * (dt / (self.mass * GYRATION * GYRATION));
        self.pose.position += self.velocity * dt;
        self.pose.rotation = (DQuat::from_scaled_axis(self.turning * dt) * self.pose.rotation).normalize();
    }
}

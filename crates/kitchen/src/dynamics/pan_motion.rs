//! Motion of the pan: it follows its target with bounded speed and acceleration.

use glam::DVec3;
use serde::{Deserialize, Serialize};

use super::pose::{Pose, about, rotation_between};

/// Natural frequency of the follower [rad/s] (chosen: a firm wrist; settles in a tenth of a second).
const STIFFNESS: f64 = 60.0;
/// Largest speed [m/s] and acceleration [m/s²] (chosen: a quick toss; a strong arm reaches about 3 g with a 1.5 kg pan).
const FASTEST: f64 = 2.0;
const STRONGEST: f64 = 40.0;
/// Largest angular velocity [rad/s] and angular acceleration [rad/s²] (chosen: a quick wrist).
const FASTEST_TURN: f64 = 12.0;
const STRONGEST_TURN: f64 = 300.0;
/// Distance [m] and speed scale [m/s] below which the pan is at its target (chosen: far below what motion shows).
const STILL: f64 = 1e-7;

/// Target of the pan: pose, velocity and acceleration.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PanTarget {
    /// Pose of the pan's floor.
    pub pose: Pose,
    /// Velocity of the target [m/s].
    pub velocity: DVec3,
    /// Acceleration of the target [m/s²].
    pub acceleration: DVec3,
    /// Angular velocity of the target [rad/s].
    pub turning: DVec3,
}

/// The moving pan.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Serialize)]
pub struct PanMotion {
    /// Pose of the centre of the floor's upper face.
    pub pose: Pose,
    /// Velocity [m/s].
    pub velocity: DVec3,
    /// Angular velocity [rad/s].
    pub turning: DVec3,
    /// Acceleration in the last step [m/s²].
    pub acceleration: DVec3,
}

impl PanMotion {
    /// A pan at rest at a pose.
    pub fn standing(pose: Pose) -> Self {
        Self { pose, ..Self::default() }
    }

    /// One step of `dt` [s] towards the target: a critically damped follower with bounded acceleration and speed.
    pub fn follow(&mut self, target: &PanTarget, dt: f64) {
        if self.is_at(target) {
            *self = Self::standing(target.pose);
            return;
        }
        let pull = STIFFNESS * STIFFNESS * (target.pose.position - self.pose.position)
            + 2.0 * STIFFNESS * (target.velocity - self.velocity)
            + target.acceleration;
        let before = self.velocity;
        self.velocity = (before + pull.clamp_length_max(STRONGEST) * dt).clamp_length_max(FASTEST);
        self.acceleration = (self.velocity - before) / dt;
        self.pose.position += self.velocity * dt;
        let error = rotation_between(self.pose.rotation, target.pose.rotation);
        let twist = STIFFNESS * STIFFNESS * error + 2.0 * STIFFNESS * (target.turning - self.turning);
        self.turning = (self.turning + twist.clamp_length_max(STRONGEST_TURN) * dt).clamp_length_max(FASTEST_TURN);
        self.pose.rotation = (about(self.turning * dt) * self.pose.rotation).normalize();
    }

    fn is_at(&self, target: &PanTarget) -> bool {
        let still = target.velocity == DVec3::ZERO && target.turning == DVec3::ZERO;
        still
            && (target.pose.position - self.pose.position).length() < STILL
            && self.velocity.length() < 100.0 * STILL
            && rotation_between(self.pose.rotation, target.pose.rotation).length() < 10.0 * STILL
            && self.turning.length() < 1000.0 * STILL
    }

    /// Returns true if the pan is at rest.
    pub fn is_still(&self) -> bool {
        self.velocity == DVec3::ZERO && self.turning == DVec3::ZERO
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn run(target: &PanTarget, seconds: f64) -> (PanMotion, f64, f64) {
        let mut pan = PanMotion::default();
        let (mut fastest, mut strongest) = (0.0f64, 0.0f64);
        for _ in 0..(seconds * 240.0) as usize {
            pan.follow(target, 1.0 / 240.0);
            fastest = fastest.max(pan.velocity.length());
            strongest = strongest.max(pan.acceleration.length());
        }
        (pan, fastest, strongest)
    }

    #[test]
    fn the_pan_arrives_and_stands() {
        let target = PanTarget { pose: Pose::at(0.1, 0.0, 0.05).turned(DVec3::Y, 0.5), ..PanTarget::default() };
        let (pan, ..) = run(&target, 2.0);
        assert!(pan.is_still() && pan.pose == target.pose);
    }

    #[test]
    fn a_wild_hand_cannot_move_it_faster_than_its_limits() {
        let target = PanTarget { pose: Pose::at(50.0, -80.0, 9.0).turned(DVec3::X, 3.0), ..PanTarget::default() };
        let (_, fastest, strongest) = run(&target, 1.0);
        assert!(fastest <= FASTEST * (1.0 + 1e-12) && fastest > 0.9 * FASTEST, "{fastest}");
        assert!(strongest <= STRONGEST * (1.0 + 1e-9), "{strongest}");
    }
}

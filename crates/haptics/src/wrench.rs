//! Forces with torques, and velocities with turning speeds, in the kitchen's directions.

use std::ops::{Add, AddAssign, Mul, Sub};

use glam::DVec3;

/// Force [N] and torque about the pan's origin [N·m], in the kitchen's directions.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Wrench {
    /// Force [N].
    pub force: DVec3,
    /// Torque about the middle of the pan's floor [N·m].
    pub torque: DVec3,
}

/// Velocity of the pan's origin [m/s] and turning speed [rad/s].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Twist {
    /// Velocity of the middle of the pan's floor [m/s].
    pub linear: DVec3,
    /// Turning speed [rad/s].
    pub angular: DVec3,
}

impl Wrench {
    /// Nothing.
    pub const ZERO: Self = Self { force: DVec3::ZERO, torque: DVec3::ZERO };

    /// A force [N] at a point `arm` [m] away from the pan's origin.
    pub fn at(force: DVec3, arm: DVec3) -> Self {
        Self { force, torque: arm.cross(force) }
    }

    /// Power that it gives to what moves so [W].
    pub fn power(&self, twist: &Twist) -> f64 {
        self.force.dot(twist.linear) + self.torque.dot(twist.angular)
    }

    /// Whether all six numbers are finite.
    pub fn is_finite(&self) -> bool {
        self.force.is_finite() && self.torque.is_finite()
    }

    /// Force, then torque [N, N·m].
    pub fn rows(&self) -> [f64; 6] {
        let (f, t) = (self.force, self.torque);
        [f.x, f.y, f.z, t.x, t.y, t.z]
    }

    /// From force, then torque [N, N·m].
    pub fn from_rows(rows: [f64; 6]) -> Self {
        let [fx, fy, fz, tx, ty, tz] = rows;
        Self { force: DVec3::new(fx, fy, fz), torque: DVec3::new(tx, ty, tz) }
    }

    /// The same with force and torque no larger than these [N, N·m].
    pub fn clamped(&self, force: f64, torque: f64) -> Self {
        Self { force: self.force.clamp_length_max(force), torque: self.torque.clamp_length_max(torque) }
    }
}

impl Twist {
    /// Whether all six numbers are finite.
    pub fn is_finite(&self) -> bool {
        self.linear.is_finite() && self.angular.is_finite()
    }

    /// Velocity of a point `arm` [m] away from the pan's origin [m/s].
    pub fn at(&self, arm: DVec3) -> DVec3 {
        self.linear + self.angular.cross(arm)
    }
}

impl Add for Wrench {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self { force: self.force + other.force, torque: self.torque + other.torque }
    }
}

impl AddAssign for Wrench {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl Sub for Wrench {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self { force: self.force - other.force, torque: self.torque - other.torque }
    }
}

impl Mul<f64> for Wrench {
    type Output = Self;
    fn mul(self, factor: f64) -> Self {
        Self { force: self.force * factor, torque: self.torque * factor }
    }
}

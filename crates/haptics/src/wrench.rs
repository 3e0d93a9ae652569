//! Wrench and twist of the pan, in the kitchen's axes.
//!
//! Poses are [`saute_kitchen::dynamics::Pose`], the workspace's one rigid transform.

use std::ops::{Add, AddAssign, Mul, Sub};

use glam::DVec3;

/// A wrench on the pan, in the kitchen's axes [N, N·m].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Wrench {
    /// Force [N].
    pub force: DVec3,
    /// Torque about the middle of the pan's floor [N·m].
    pub torque: DVec3,
}

/// A twist of the pan, in the kitchen's axes [m/s, rad/s].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Twist {
    /// Velocity of the middle of the pan's floor [m/s].
    pub linear: DVec3,
    /// Angular velocity [rad/s].
    pub angular: DVec3,
}

impl Wrench {
    /// No force and no torque.
    pub const ZERO: Self = Self { force: DVec3::ZERO, torque: DVec3::ZERO };

    /// Returns the wrench of a force [N] that acts at `arm` from the pan's origin [m] [N, N·m].
    ///
    /// ```
    /// use glam::DVec3;
    /// use saute_haptics::Wrench;
    ///
    /// let weight = Wrench::at(DVec3::new(0.0, 0.0, -3.0), DVec3::new(0.05, 0.0, 0.0));
    /// assert!((weight.torque - DVec3::new(0.0, 0.15, 0.0)).length() < 1e-12);
    /// ```
    pub fn at(force: DVec3, arm: DVec3) -> Self {
        Self { force, torque: arm.cross(force) }
    }

    /// Returns the power of the wrench along a twist [W].
    pub fn power(&self, twist: &Twist) -> f64 {
        self.force.dot(twist.linear) + self.torque.dot(twist.angular)
    }

    /// Returns true if all six numbers are finite.
    pub fn is_finite(&self) -> bool {
        self.force.is_finite() && self.torque.is_finite()
    }

    /// Returns force, then torque [N, N·m].
    pub fn rows(&self) -> [f64; 6] {
        let (f, t) = (self.force, self.torque);
        [f.x, f.y, f.z, t.x, t.y, t.z]
    }

    /// Creates a wrench from force, then torque [N, N·m].
    pub fn from_rows(rows: [f64; 6]) -> Self {
        let [fx, fy, fz, tx, ty, tz] = rows;
        Self { force: DVec3::new(fx, fy, fz), torque: DVec3::new(tx, ty, tz) }
    }

    /// Returns the wrench with force and torque limited in magnitude [N, N·m].
    pub fn clamped(&self, force: f64, torque: f64) -> Self {
        Self { force: self.force.clamp_length_max(force), torque: self.torque.clamp_length_max(torque) }
    }
}

impl Twist {
    /// Returns true if all six numbers are finite.
    pub fn is_finite(&self) -> bool {
        self.linear.is_finite() && self.angular.is_finite()
    }

    /// Returns the velocity of the point at `arm` from the pan's origin [m] [m/s].
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

//! Rigid transforms: position and orientation of a body.
//!
//! This is the rigid transform of the simulation, in 64-bit floats. The picture's pose is a 32-bit copy with the lift of
//! racks and domes added, and the rigid-body solver's 32-bit pose is converted in `scale`. One common type would round
//! one of them differently.

use glam::{DQuat, DVec3};
use serde::{Deserialize, Serialize};

/// Position and orientation of a body in the kitchen [m]: x to the right, y away from the cook, z up; the origin is the
/// ring's centre on the hob's glass.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Serialize)]
pub struct Pose {
    /// Position of its origin [m].
    pub position: DVec3,
    /// Orientation as a unit quaternion [-].
    pub rotation: DQuat,
}

impl Default for Pose {
    fn default() -> Self {
        Self { position: DVec3::ZERO, rotation: DQuat::IDENTITY }
    }
}

impl Pose {
    /// Pose without rotation at a position [m].
    pub fn at(x: f64, y: f64, z: f64) -> Self {
        Self { position: DVec3::new(x, y, z), rotation: DQuat::IDENTITY }
    }

    /// Returns true if all components are finite.
    pub fn is_finite(&self) -> bool {
        self.position.is_finite() && self.rotation.is_finite()
    }

    /// Transforms a point from the body's frame to the kitchen's [m].
    pub fn to_world(&self, point: DVec3) -> DVec3 {
        self.position + self.rotation * point
    }

    /// Transforms a point from the kitchen's frame to the body's [m].
    pub fn to_body(&self, point: DVec3) -> DVec3 {
        self.rotation.conjugate() * (point - self.position)
    }

    /// Composition: the pose of a body whose pose in this frame is `inner`.
    pub fn then(&self, inner: &Self) -> Self {
        Self { position: self.to_world(inner.position), rotation: (self.rotation * inner.rotation).normalize() }
    }

    /// This pose expressed in another frame.
    pub fn seen_from(&self, frame: &Self) -> Self {
        Self {
            position: frame.to_body(self.position),
            rotation: (frame.rotation.conjugate() * self.rotation).normalize(),
        }
    }

    /// Upward direction of the kitchen in the body's frame [-].
    pub fn up(&self) -> [f64; 3] {
        (self.rotation.conjugate() * DVec3::Z).to_array()
    }

    /// This pose rotated by an angle [rad] about a unit axis of the kitchen through the body's origin.
    pub fn turned(&self, axis: DVec3, angle: f64) -> Self {
        Self { position: self.position, rotation: (turn(axis, angle) * self.rotation).normalize() }
    }

    /// Interpolates from this (0) to another (1): linear in position, along the shorter arc in orientation.
    pub fn towards(&self, other: &Self, share: f64) -> Self {
        let turn = rotation_between(self.rotation, other.rotation) * share;
        Self {
            position: self.position.lerp(other.position, share),
            rotation: (about(turn) * self.rotation).normalize(),
        }
    }
}

/// Rotation by an angle [rad] about a unit axis.
pub fn turn(axis: DVec3, angle: f64) -> DQuat {
    about(axis * angle)
}

/// Rotation of a rotation vector, axis times angle [rad].
pub fn about(vector: DVec3) -> DQuat {
    let angle = vector.length();
    if angle < 1e-12 {
        return DQuat::IDENTITY;
    }
    let (sin, cos) = libm::sincos(0.5 * angle);
    let v = vector * (sin / angle);
    DQuat::from_xyzw(v.x, v.y, v.z, cos)
}

/// Rotation vector of the shorter arc from `from` to `to` in the kitchen's frame [rad].
pub fn rotation_between(from: DQuat, to: DQuat) -> DVec3 {
    let mut q = to * from.conjugate();
    if q.w < 0.0 {
        q = -q;
    }
    let v = DVec3::new(q.x, q.y, q.z);
    let sine = v.length();
    if sine < 1e-9 { 2.0 * v } else { v * (2.0 * libm::atan2(sine, q.w) / sine) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn poses_compose_and_invert() {
        let a = Pose::at(0.1, -0.2, 0.3).turned(DVec3::new(0.6, 0.0, 0.8), 0.7);
        let b = Pose::at(-0.05, 0.02, 0.01).turned(DVec3::Y, -1.2);
        let c = a.then(&b);
        let p = DVec3::new(0.01, 0.02, 0.03);
        assert!((c.to_world(p) - a.to_world(b.to_world(p))).length() < 1e-15);
        assert!((c.to_body(c.to_world(p)) - p).length() < 1e-15);
        let back = c.seen_from(&a);
        assert!((back.position - b.position).length() < 1e-15);
        assert!(rotation_between(back.rotation, b.rotation).length() < 1e-12);
    }

    #[test]
    fn half_way_between_two_poses_is_half_the_turn() {
        let a = Pose::default();
        let b = Pose::at(0.2, 0.0, 0.0).turned(DVec3::X, 3.0);
        let middle = a.towards(&b, 0.5);
        assert!((rotation_between(DQuat::IDENTITY, middle.rotation) - DVec3::X * 1.5).length() < 1e-12);
        assert!((middle.position.x - 0.1).abs() < 1e-15);
        assert!((a.turned(DVec3::X, core::f64::consts::PI).up()[2] + 1.0).abs() < 1e-12);
    }
}

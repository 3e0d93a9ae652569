//! Tilt limit and smoothed rotation of a pan.

use glam::{DQuat, DVec3};
use saute_kitchen::dynamics::pose::{about, rotation_between, turn};

/// Returns a rotation whose tilt from upright is limited to `most` [rad].
pub fn within_tilt(rotation: DQuat, most: f64) -> DQuat {
    let up = rotation * DVec3::Z;
    let tilt = libm::acos(up.z.clamp(-1.0, 1.0));
    if tilt <= most {
        return rotation;
    }
    let axis = up.cross(DVec3::Z);
    let axis = if axis.length() < 1e-9 { DVec3::X } else { axis.normalize() };
    (turn(axis, tilt - most) * rotation).normalize()
}

/// Returns the rotation after one step of first-order smoothing towards `to`: the rest decays as e^(−dt/τ), times in [s].
pub fn eased(from: DQuat, to: DQuat, dt: f64, tau: f64) -> DQuat {
    let share = 1.0 - libm::exp(-dt / tau);
    (about(rotation_between(from, to) * share) * from).normalize()
}

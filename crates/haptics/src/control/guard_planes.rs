//! Guard planes: walls that the pan cannot pass, such as the hob's glass under its edge.

use glam::DVec3;
use saute_kitchen::dynamics::Pose;

use crate::control::feel::GuardFeel;
use crate::device::Limits;
use crate::kitchen::contact_model::{PLANES, Plane};
use crate::wrench::{Twist, Wrench};

/// Virtual walls as unilateral springs with dampers [N]: F = K d + B ḋ along the wall's normal, never towards the wall.
///
/// d is the penetration depth of the touching point [m].
#[derive(Clone, Copy, Debug)]
pub struct GuardPlanes {
    stiffness: f64,
    damping: f64,
}

impl GuardPlanes {
    /// Creates walls with the greatest stiffness that the device renders stably.
    pub fn new(feel: &GuardFeel, limits: &Limits) -> Self {
        Self { stiffness: limits.stiffness_n_m, damping: feel.damping_n_s_m }
    }

    /// Returns the wrench of all walls on a pan with this pose and twist [N, N·m].
    pub fn wrench(&self, planes: &[Plane; PLANES], pose: &Pose, twist: &Twist) -> Wrench {
        let touching = planes.iter().filter(|p| p.normal != DVec3::ZERO);
        touching.map(|p| self.one(p, pose, twist)).fold(Wrench::ZERO, |sum, w| sum + w)
    }

    fn one(&self, plane: &Plane, pose: &Pose, twist: &Twist) -> Wrench {
        let arm = lowest(plane, pose);
        let depth = plane.at_least - plane.normal.dot(pose.position + arm);
        if depth <= 0.0 {
            return Wrench::ZERO;
        }
        let closing = -plane.normal.dot(twist.at(arm));
        let push = (self.stiffness * depth + self.damping * closing).max(0.0);
        // A flat pan is pushed at its middle, a tilted one at the edge that touches.
        Wrench::at(plane.normal * push, arm)
    }
}

/// Returns the point of the floor's edge that is nearest to the wall, relative to the pan's origin [m].
fn lowest(plane: &Plane, pose: &Pose) -> DVec3 {
    let up = pose.rotation * DVec3::Z;
    let across = plane.normal - up * plane.normal.dot(up);
    // A nearly level edge touches all around: below a tilt of FLAT the contact point moves towards the middle.
    let share = (across.length() / FLAT).min(1.0);
    -across.normalize_or_zero() * (plane.edge_radius * share) - up * plane.below
}

/// Sine of the tilt above which a pan stands on its edge [-] (chosen: half a degree, less than the error of a hand that keeps it level).
const FLAT: f64 = 0.01;

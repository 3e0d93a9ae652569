//! Walls that the pan cannot pass: the hob's glass under its edge.

use glam::DVec3;
use saute_kitchen::dynamics::Pose;

use crate::kitchen::contact_model::{PLANES, Plane};
use crate::device::Limits;
use crate::control::feel::GuardFeel;
use crate::wrench::{Twist, Wrench};

/// Virtual coupling to the nearest pose that no wall forbids: F = K d + B ḋ along the wall's normal, at the point that
/// touches it, only ever away from the wall [N]. d is the depth [m].
#[derive(Clone, Copy, Debug)]
pub struct GuardPlanes {
    stiffness: f64,
    damping: f64,
}

impl GuardPlanes {
    /// As stiff as the device stays stable with.
    pub fn new(feel: &GuardFeel, limits: &Limits) -> Self {
        Self { stiffness: limits.stiffness_n_m, damping: feel.damping_n_s_m }
    }

    /// What the walls do to the pan there.
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
        // While the pan stands flat, the push goes through its middle; tilted, through the edge that touches.
        Wrench::at(plane.normal * push, arm)
    }
}

/// The point of the floor's edge that is nearest to the wall, from the pan's origin [m].
fn lowest(plane: &Plane, pose: &Pose) -> DVec3 {
    let up = pose.rotation * DVec3::Z;
    let across = plane.normal - up * plane.normal.dot(up);
    // An edge that is hardly tilted touches all around: its middle stands for it until it is tilted by FLAT.
    let share = (across.length() / FLAT).min(1.0);
    -across.normalize_or_zero() * (plane.edge_radius * share) - up * plane.below
}

/// Tilt from which a pan stands on its edge [-] (chosen: half a degree).
const FLAT: f64 = 0.01;

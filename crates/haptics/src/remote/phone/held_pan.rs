//! The pan that a phone holds: it turns with the phone, a toss moves it, and without a phone it goes home.

use glam::{DQuat, DVec3};
use saute_kitchen::dynamics::Pose;
use saute_kitchen::dynamics::pose::rotation_between;

use super::toss::Toss;
use crate::remote::remote_pose::{FOLLOW_S, HOME_S};
use crate::remote::tilt::{eased, within_tilt};
use crate::wrench::Twist;

/// Half width of the range of motion along each axis [m] (chosen: at home the pan stands on the hob; a toss lifts it).
pub const HALF_M: [f64; 3] = [0.15, 0.15, 0.2];
/// Largest tilt [rad] (chosen: 120°, a pan that is emptied).
pub const TILT_RAD: f64 = std::f64::consts::FRAC_PI_3 * 2.0;

/// The pan in a hand that holds a phone.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct HeldPan {
    toss: Toss,
    rotation: DQuat,
}

impl HeldPan {
    /// Moves the pan over `dt` [s] and returns its twist: with a phone towards the rotation that it requests, under its acceleration
    /// [m/s²] if that is known; without one back home.
    pub fn step(&mut self, phone: Option<(DQuat, Option<DVec3>)>, dt: f64) -> Twist {
        self.toss.step(phone.and_then(|(_, push)| push), DVec3::from_array(HALF_M), dt);
        let (target, tau) = phone.map_or((DQuat::IDENTITY, HOME_S), |(rotation, _)| (rotation, FOLLOW_S));
        let before = self.rotation;
        self.rotation = eased(before, within_tilt(target, TILT_RAD), dt, tau);
        let angular = rotation_between(before, self.rotation) / dt.max(1e-6);
        Twist { linear: self.toss.velocity, angular }
    }

    /// Returns the pose of the pan; at home it is on its ring.
    pub fn pose(&self) -> Pose {
        Pose { position: self.toss.place, rotation: self.rotation }
    }
}

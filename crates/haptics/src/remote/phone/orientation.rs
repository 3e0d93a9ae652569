//! How a phone lies in the hand, as a browser's angles tell it, and how the pan is turned then.

use glam::{DQuat, DVec3};
use saute_kitchen::dynamics::pose::turn;

use super::message::Measured;
use crate::kitchen::kitchen_watch::GRAVITY;

/// Steepest phone that may be called flat [rad] (chosen: 30°, as it lies in a hand).
const FLAT: f64 = 0.52;

/// From the angles of a DeviceOrientation event [°] to the turn from the phone's axes (x right, y to its top, z out of the screen) to
/// east, north, up: R = R_z(α) R_x(β) R_y(γ), the specification's intrinsic Z-X′-Y″.
pub fn from_angles([alpha, beta, gamma]: [f64; 3]) -> DQuat {
    turn(DVec3::Z, alpha.to_radians()) * turn(DVec3::X, beta.to_radians()) * turn(DVec3::Y, gamma.to_radians())
}

/// What counts as level and straight ahead.
#[derive(Clone, Copy, Debug, Default)]
pub struct Level {
    /// Heading of the cook, about the vertical [rad]; none before the first message.
    heading: Option<DQuat>,
    /// How the phone lies when the pan is level, after the heading.
    tilt: DQuat,
}

impl Level {
    /// Turn of the pan in the kitchen; the first one tells where the cook looks.
    pub fn pan(&mut self, phone: DQuat) -> DQuat {
        let heading = *self.heading.get_or_insert_with(|| heading(phone));
        (heading.conjugate() * phone * self.tilt.conjugate()).normalize()
    }

    /// A direction of the phone, in the kitchen.
    pub fn direction(&self, phone: DQuat, v: DVec3) -> DVec3 {
        self.heading.unwrap_or(DQuat::IDENTITY).conjugate() * (phone * v)
    }

    /// The phone lies level now and its top points away from the cook; false where it is too steep for that.
    pub fn set(&mut self, phone: DQuat) -> bool {
        let steep = libm::acos((phone * DVec3::Z).z.clamp(-1.0, 1.0));
        if steep > FLAT {
            return false;
        }
        let heading = heading(phone);
        *self = Self { heading: Some(heading), tilt: (heading.conjugate() * phone).normalize() };
        true
    }
}

/// The turn about the vertical alone by which the phone's top points where it does.
fn heading(phone: DQuat) -> DQuat {
    let top = phone * DVec3::Y;
    let length = libm::hypot(top.x, top.y);
    if length < 1e-6 { DQuat::IDENTITY } else { turn(DVec3::Z, libm::atan2(-top.x, top.y)) }
}

/// Acceleration of the phone without gravity, along its own axes [m/s²]; none where nothing is known.
///
/// Some systems tell all accelerations with the opposite sign: what they feel at rest points down then, and both are
/// turned round.
pub fn acceleration(measured: &Measured, phone: DQuat) -> Option<DVec3> {
    let up = phone.conjugate() * DVec3::Z;
    let felt = measured.felt.map(DVec3::from_array);
    match (measured.push.map(DVec3::from_array), felt) {
        (Some(push), Some(felt)) => Some(if (felt - push).dot(up) < 0.0 { -push } else { push }),
        (Some(push), None) => Some(push),
        (None, Some(felt)) => {
            let felt = if felt.dot(up) < 0.0 { -felt } else { felt };
            Some(felt - up * GRAVITY)
        }
        (None, None) => None,
    }
}

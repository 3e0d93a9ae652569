//! Orientation: from the browser's angles to the pan's rotation.

use glam::{DQuat, DVec3};
use saute_kitchen::dynamics::pose::turn;

use super::message::Measured;
use crate::kitchen::kitchen_watch::GRAVITY;

/// Largest tilt that can be set as level [rad] (chosen: 30°, as a phone is in a hand).
const FLAT: f64 = 0.52;

/// Returns the rotation from the phone's axes to east, north, up for the angles of a DeviceOrientation event [°].
///
/// R = R_z(α) R_x(β) R_y(γ), the specification's intrinsic Z-X′-Y″ angles. The phone's axes are x right, y to its top, z out of the
/// screen (W3C Device Orientation and Motion).
pub fn from_angles([alpha, beta, gamma]: [f64; 3]) -> DQuat {
    turn(DVec3::Z, alpha.to_radians()) * turn(DVec3::X, beta.to_radians()) * turn(DVec3::Y, gamma.to_radians())
}

/// The reference orientation: level and straight ahead.
#[derive(Clone, Copy, Debug, Default)]
pub struct Level {
    /// Heading of the cook, a rotation about the vertical; none before the first message.
    heading: Option<DQuat>,
    /// Tilt of the phone when the pan is level, relative to the heading.
    tilt: DQuat,
}

impl Level {
    /// Returns the pan's rotation in the kitchen; the first call sets the heading of the cook.
    pub fn pan(&mut self, phone: DQuat) -> DQuat {
        let heading = *self.heading.get_or_insert_with(|| heading(phone));
        (heading.conjugate() * phone * self.tilt.conjugate()).normalize()
    }

    /// Returns a direction of the phone in the kitchen's axes.
    pub fn direction(&self, phone: DQuat, v: DVec3) -> DVec3 {
        self.heading.unwrap_or(DQuat::IDENTITY).conjugate() * (phone * v)
    }

    /// Sets the present orientation as level and straight ahead; returns false if the phone is too steep.
    pub fn set(&mut self, phone: DQuat) -> bool {
        self.set_within(FLAT, phone)
    }

    /// As [`Self::set`], with the largest tilt that can be set as level [rad]; the heading is known up to a right angle.
    pub fn set_within(&mut self, most: f64, phone: DQuat) -> bool {
        let steep = libm::acos((phone * DVec3::Z).z.clamp(-1.0, 1.0));
        if steep > most {
            return false;
        }
        let heading = heading(phone);
        *self = Self { heading: Some(heading), tilt: (heading.conjugate() * phone).normalize() };
        true
    }
}

/// Returns the rotation about the vertical that gives the direction of the phone's top.
fn heading(phone: DQuat) -> DQuat {
    let top = phone * DVec3::Y;
    let length = libm::hypot(top.x, top.y);
    if length < 1e-6 { DQuat::IDENTITY } else { turn(DVec3::Z, libm::atan2(-top.x, top.y)) }
}

/// Returns the acceleration of the phone without gravity, along its own axes [m/s²]; `None` if it is unknown.
///
/// Some systems report all accelerations with the opposite sign. Their reading at rest then points down, and both readings are
/// negated.
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

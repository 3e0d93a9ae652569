//! The hand that holds the pan.

use glam::DVec3;
use serde::{Deserialize, Serialize};

use crate::dynamics::{Gesture, Pose};

/// How the pan is held.
#[derive(Clone, Copy, Debug, Deserialize, Serialize)]
pub(crate) struct PanHold {
    /// Pose at which the pan is held between gestures.
    pub(crate) pose: Pose,
    /// Gesture of the pan and the time since its start [s].
    pub(crate) gesture: Option<(Gesture, f64)>,
    /// The pan's velocity at the last tick [m/s].
    pub(crate) last_velocity: DVec3,
}

impl PanHold {
    /// A pan held at rest.
    pub(crate) fn at(pose: Pose) -> Self {
        Self { pose, gesture: None, last_velocity: DVec3::ZERO }
    }

    /// Returns true if a toss has not begun: it waits for the second hand, whose tool would be below the food.
    pub(crate) fn waits(&self) -> bool {
        matches!(self.gesture, Some((Gesture::Toss { .. }, 0.0)))
    }
}

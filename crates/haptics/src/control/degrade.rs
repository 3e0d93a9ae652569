//! Degraded rendering: what a device shows of the requested wrench and rumble when it lacks degrees of freedom.

use serde::Serialize;

use crate::control::rumble::Rumble;
use crate::device::{Capabilities, Vibration};
use crate::kitchen::kitchen_watch::GRAVITY;
use crate::wrench::Wrench;

/// What a device renders; sound and picture are always present and are the last fallback.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Rendering {
    /// Forces and torques.
    Wrench,
    /// Forces alone; torques are only visible.
    Force,
    /// Collisions, sliding and boiling as rumble; weights are only visible.
    Rumble,
    /// Nothing in the hand.
    SoundAndPicture,
}

/// The rules, richest first: least number of actuated degrees of freedom, rumble motors required, resulting rendering.
pub const RULES: [(u8, bool, Rendering); 4] = [
    (6, false, Rendering::Wrench),
    (3, false, Rendering::Force),
    (0, true, Rendering::Rumble),
    (0, false, Rendering::SoundAndPicture),
];

impl Capabilities {
    /// Returns the rendering of the first rule that the device meets.
    pub fn rendering(&self) -> Rendering {
        let rumbles = self.vibration == Vibration::Rumble;
        let meets = |(dof, rumble, _): &&(u8, bool, Rendering)| self.dof_actuated >= *dof && (!rumble || rumbles);
        RULES.iter().find(meets).map_or(Rendering::SoundAndPicture, |(_, _, rendering)| *rendering)
    }

    /// Returns the part of a wrench that the device can show [N, N·m].
    pub fn shown(&self, wrench: &Wrench) -> Wrench {
        match self.rendering() {
            Rendering::Wrench => *wrench,
            Rendering::Force => Wrench { force: wrench.force, ..Wrench::ZERO },
            Rendering::Rumble | Rendering::SoundAndPicture => Wrench::ZERO,
        }
    }

    /// Returns true if the weight of the pan itself is rendered.
    ///
    /// That needs a hand that holds no real pan and a device that can carry twice the pan's weight. Otherwise the pan is
    /// weightless and only its contents are felt.
    pub fn renders_pan(&self, pan_kg: f64) -> bool {
        !self.holds_real_pan && self.limits.force_n >= 2.0 * pan_kg * GRAVITY
    }

    /// Returns the rumble that the device gets [-]: all of it on a rumble device, none on a device that renders vibration as
    /// force.
    pub fn rumbled(&self, rumble: &Rumble) -> Rumble {
        if self.rendering() == Rendering::Rumble { *rumble } else { Rumble::default() }
    }
}

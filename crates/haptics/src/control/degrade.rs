//! What is shown of what a hand should feel, where a device lacks something: wrench, force, rumble, sound and picture.

use serde::Serialize;

use crate::device::{Capabilities, Vibration};
use crate::kitchen::kitchen_watch::GRAVITY;
use crate::control::rumble::Rumble;
use crate::wrench::Wrench;

/// How much a device shows; sound and picture always are there, and are all that is left in the end.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Rendering {
    /// Forces and torques.
    Wrench,
    /// Forces alone; torques are seen.
    Force,
    /// Collisions, sliding and boiling as rumble; weights are seen.
    Rumble,
    /// Nothing in the hand.
    SoundAndPicture,
}

/// The rules, the richest first: least degrees of freedom that are moved, whether rumble will do, and what is shown then.
pub const RULES: [(u8, bool, Rendering); 4] = [
    (6, false, Rendering::Wrench),
    (3, false, Rendering::Force),
    (0, true, Rendering::Rumble),
    (0, false, Rendering::SoundAndPicture),
];

impl Capabilities {
    /// How much it shows: the first rule that it meets.
    pub fn rendering(&self) -> Rendering {
        let rumbles = self.vibration == Vibration::Rumble;
        let meets = |(dof, rumble, _): &&(u8, bool, Rendering)| self.dof_actuated >= *dof && (!rumble || rumbles);
        RULES.iter().find(meets).map_or(Rendering::SoundAndPicture, |(_, _, rendering)| *rendering)
    }

    /// What of a wrench the device can show.
    pub fn shown(&self, wrench: &Wrench) -> Wrench {
        match self.rendering() {
            Rendering::Wrench => *wrench,
            Rendering::Force => Wrench { force: wrench.force, ..Wrench::ZERO },
            Rendering::Rumble | Rendering::SoundAndPicture => Wrench::ZERO,
        }
    }

    /// Whether the weight of the pan itself is rendered too: where the hand holds no real one, and the device can carry twice as
    /// much; else the pan is weightless, and what lies in it is felt.
    pub fn renders_pan(&self, pan_kg: f64) -> bool {
        !self.holds_real_pan && self.limits.force_n >= 2.0 * pan_kg * GRAVITY
    }

    /// What of a rumble the device is told: all where it rumbles; a device of forces renders vibration by them.
    pub fn rumbled(&self, rumble: &Rumble) -> Rumble {
        if self.rendering() == Rendering::Rumble { *rumble } else { Rumble::default() }
    }
}

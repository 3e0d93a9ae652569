//! Moves the kitchen's turner with a device.

use glam::DQuat;
use saute_kitchen::dynamics::{Pose, Tool};
use saute_kitchen::hands::ranges::usable;
use saute_kitchen::{Command, Kitchen};

/// State of the turner that a device with position and orientation moves, without force feedback.
#[derive(Clone, Copy, Debug, Default)]
pub struct TurnerInHand {
    leads: bool,
}

/// Returns the blade's pose for a grip's pose: the grip's +y axis is the blade's front, which points away from the cook.
pub fn blade_of(grip: &Pose) -> Pose {
    let front = DQuat::from_rotation_z(std::f64::consts::FRAC_PI_2);
    Pose { position: grip.position, rotation: (grip.rotation * front).normalize() }
}

impl TurnerInHand {
    /// Moves the turner to a grip's pose before a frame; without a grip the turner lays down its load and is put away.
    pub fn step(&mut self, grip: Option<&Pose>, kitchen: &mut Kitchen) {
        match grip.map(usable) {
            Some(Ok(grip)) => {
                self.leads = true;
                let lead = Command::Lead { tool: Tool::Turner, to: blade_of(&grip), grip: None };
                // The command names no food to grip, so it is refused only under the lid.
                let _ = kitchen.apply(&lead);
            }
            // A pose that is none: the turner stays where it is.
            Some(Err(_)) => {}
            None if std::mem::take(&mut self.leads) => {
                let _ = kitchen.apply(&Command::LetGo);
            }
            None => {}
        }
    }

    /// Returns true while a device moves the turner.
    pub fn leads(&self) -> bool {
        self.leads
    }
}

//! The kitchen's turner where the other hand holds a device.

use glam::DQuat;
use saute_kitchen::dynamics::{Pose, Tool};
use saute_kitchen::{Command, Kitchen};

/// Leads the kitchen's turner by a device that senses place and turning, without force.
#[derive(Clone, Copy, Debug, Default)]
pub struct TurnerInHand {
    leads: bool,
}

/// The blade of a grip that is held upright points away from the cook: the grip's +y is the blade's front.
pub fn blade_of(grip: &Pose) -> Pose {
    let front = DQuat::from_rotation_z(std::f64::consts::FRAC_PI_2);
    Pose { position: grip.position, rotation: (grip.rotation * front).normalize() }
}

impl TurnerInHand {
    /// Before a frame: leads the turner to a grip's pose; without one it lays down what it holds and is put away.
    pub fn step(&mut self, grip: Option<&Pose>, kitchen: &mut Kitchen) {
        match grip.filter(|g| g.position.is_finite() && g.rotation.is_finite()) {
            Some(grip) => {
                self.leads = true;
                let lead = Command::Lead { tool: Tool::Turner, to: blade_of(grip), grip: None };
                // Nothing is gripped by name, so nothing is refused.
                let _ = kitchen.apply(&lead);
            }
            None if std::mem::take(&mut self.leads) => {
                let _ = kitchen.apply(&Command::LetGo);
            }
            None => {}
        }
    }

    /// Whether a hand leads the turner.
    pub fn leads(&self) -> bool {
        self.leads
    }
}

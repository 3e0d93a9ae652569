//! A template for drivers: a simulated weight on a spring. To add a device, copy this file and follow the steps.

use glam::DVec3;

use crate::device::{
    Capabilities, HapticCommand, HapticDevice, HapticSample, Health, Limits, Sensed, Vibration, Workspace,
};
use crate::wrench::Wrench;
use saute_kitchen::dynamics::Pose;

/// A simulated mass on a spring that a relaxed arm holds.
///
/// Step 1. Hold what the device needs: a port, a socket, the last sample. All memory is allocated here and none later.
#[derive(Clone, Debug)]
pub struct WeightOnSpring {
    capabilities: Capabilities,
    position: DVec3,
    velocity: DVec3,
    time_s: f64,
    stopped: bool,
}

/// Stiffness [N/m], damping [N·s/m] and mass [kg] of the holding hand (chosen: a relaxed arm).
const HAND: [f64; 3] = [200.0, 8.0, 1.0];

impl Default for WeightOnSpring {
    /// Step 2. State the device's capabilities as data. Everything else follows: [`Capabilities::shown`] leaves out what the
    /// device cannot render, no force exceeds its limits, and without a real pan the pan's weight is rendered too.
    fn default() -> Self {
        let capabilities = Capabilities {
            name: "A weight on a spring, in memory".into(),
            sensed: Sensed::Place,
            dof_actuated: 3,
            limits: Limits {
                force_n: 10.0,
                torque_nm: 0.0,
                slew_n_s: 2000.0,
                slew_nm_s: 0.0,
                energy_j: 1.0,
                stiffness_n_m: 1000.0,
                stiffness_nm_rad: 0.0,
            },
            workspace: Workspace { home_m: [0.0, 0.0, 0.1], half_m: [0.1; 3], tilt_rad: 0.0 },
            rate_hz: 1000.0,
            vibration: Vibration::Wrench,
            holds_real_pan: true,
            real_mass_kg: HAND[2],
        };
        let position = DVec3::from_array(capabilities.workspace.home_m);
        Self { capabilities, position, velocity: DVec3::ZERO, time_s: 0.0, stopped: false }
    }
}

impl HapticDevice for WeightOnSpring {
    fn capabilities(&self) -> &Capabilities {
        &self.capabilities
    }

    /// Step 3. Send the command, receive the sample, return at once. Never wait, lock or allocate. When the device is not
    /// connected, return its [`Health`] and keep looking for it.
    fn exchange(&mut self, command: &HapticCommand, dt: f64) -> HapticSample {
        // Step 4. Make force only while forces are enabled.
        let shown = if command.enabled && !self.stopped { command.wrench.force } else { DVec3::ZERO };
        let home = DVec3::from_array(self.capabilities.workspace.home_m);
        let [stiffness, damping, mass] = HAND;
        let force = shown + (home - self.position) * stiffness - self.velocity * damping;
        self.velocity += force * (dt / mass);
        self.position += self.velocity * dt;
        self.time_s += dt;
        // Step 5. Return pose and twist in the kitchen's frame, and the wrench that the device really makes.
        HapticSample {
            time_s: self.time_s,
            pose: Pose { position: self.position, ..Pose::default() },
            leads_pan: true,
            twist: crate::wrench::Twist { linear: self.velocity, ..Default::default() },
            achieved: Wrench { force: shown, ..Wrench::ZERO },
            total_force_n: shown.length(),
            length_misfit: 0.0,
            tension_n: None,
            turner: None,
            health: if self.stopped { Health::Stopped } else { Health::Running },
            fresh: true,
            buttons: 0,
            rejected: 0,
        }
    }

    /// Step 6. Release all forces at once, until a hand resumes.
    fn stop(&mut self) {
        self.stopped = true;
    }

    fn resume(&mut self) {
        self.stopped = false;
    }
}

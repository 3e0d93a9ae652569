//! Impulse train: collisions rendered as short half-sine force pulses.

use glam::DVec3;
use saute_kitchen::dynamics::Pose;

use crate::control::feel::ImpulseFeel;
use crate::kitchen::contact_model::{IMPULSES, Impulse};
use crate::wrench::Wrench;

/// Pulses that may overlap (chosen: the collisions of two models).
const PUSHES: usize = 2 * IMPULSES;

#[derive(Clone, Copy, Debug, Default)]
struct Push {
    impulse: DVec3,
    at: DVec3,
    since: f64,
    active: bool,
}

/// Renders each collision once as a half sine [N]: F(t) = J π/(2T) sin(π t/T) for 0 < t < T, whose integral is J.
#[derive(Clone, Copy, Debug)]
pub struct ImpulseTrain {
    duration: f64,
    least: f64,
    seen: Option<u64>,
    pushes: [Push; PUSHES],
}

impl ImpulseTrain {
    /// Creates an empty train.
    pub fn new(feel: &ImpulseFeel) -> Self {
        Self { duration: feel.duration_s, least: feel.least_n_s, seen: None, pushes: [Push::default(); PUSHES] }
    }

    /// Starts a pulse for each new collision and returns the energy of these collisions [J].
    pub fn take(&mut self, impulses: &[Impulse; IMPULSES]) -> f64 {
        let newest = impulses.iter().map(|i| i.number).max().unwrap_or(0);
        // Collisions from before the first call are not rendered.
        let seen = self.seen.replace(newest).unwrap_or(newest);
        let mut energy = 0.0;
        for impulse in impulses.iter().filter(|i| i.number > seen && i.impulse.length() >= self.least) {
            if let Some(push) = self.pushes.iter_mut().find(|p| !p.active) {
                *push = Push { impulse: impulse.impulse, at: impulse.at, since: 0.0, active: true };
                energy += impulse.energy;
            }
        }
        energy
    }

    /// Returns the mean wrench of all pulses over a step of `dt` [s] and advances them [N, N·m].
    pub fn step(&mut self, pose: &Pose, dt: f64) -> Wrench {
        let mut sum = Wrench::ZERO;
        for push in self.pushes.iter_mut().filter(|p| p.active) {
            let phase = |t: f64| libm::cos(std::f64::consts::PI * (t / self.duration).min(1.0));
            // The mean over the step makes the sum of all steps equal the impulse, whatever the step length.
            let share = 0.5 * (phase(push.since) - phase(push.since + dt));
            sum += Wrench::at(push.impulse * (share / dt), pose.rotation * push.at);
            push.since += dt;
            push.active = push.since < self.duration;
        }
        sum
    }
}

//! Collisions as short pushes.

use glam::DVec3;
use saute_kitchen::dynamics::Pose;

use crate::kitchen::contact_model::{IMPULSES, Impulse};
use crate::control::feel::ImpulseFeel;
use crate::wrench::Wrench;

/// Pushes that may overlap.
const PUSHES: usize = 2 * IMPULSES;

#[derive(Clone, Copy, Debug, Default)]
struct Push {
    impulse: DVec3,
    at: DVec3,
    since: f64,
    active: bool,
}

/// Renders each collision once: F(t) = J π/(2T) sin(π t/T) for 0 < t < T, whose integral is J [N].
#[derive(Clone, Copy, Debug)]
pub struct ImpulseTrain {
    duration: f64,
    least: f64,
    seen: Option<u64>,
    pushes: [Push; PUSHES],
}

impl ImpulseTrain {
    /// None yet.
    pub fn new(feel: &ImpulseFeel) -> Self {
        Self { duration: feel.duration_s, least: feel.least_n_s, seen: None, pushes: [Push::default(); PUSHES] }
    }

    /// Takes over the collisions that are new; gives the energy that they bring [J].
    pub fn take(&mut self, impulses: &[Impulse; IMPULSES]) -> f64 {
        let newest = impulses.iter().map(|i| i.number).max().unwrap_or(0);
        // What happened before the hand was there is not felt.
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

    /// What is felt in a step of `dt` [s].
    pub fn step(&mut self, pose: &Pose, dt: f64) -> Wrench {
        let mut sum = Wrench::ZERO;
        for push in self.pushes.iter_mut().filter(|p| p.active) {
            let phase = |t: f64| libm::cos(std::f64::consts::PI * (t / self.duration).min(1.0));
            // The mean over the step, so that the sum of all steps is the impulse whatever their length.
            let share = 0.5 * (phase(push.since) - phase(push.since + dt));
            sum += Wrench::at(push.impulse * (share / dt), pose.rotation * push.at);
            push.since += dt;
            push.active = push.since < self.duration;
        }
        sum
    }
}

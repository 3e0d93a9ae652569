//! Rumble: collisions, sliding and boiling for devices with vibration motors only.

use serde::Serialize;

use crate::control::feel::Feel;
use crate::control::vibration;
use crate::kitchen::contact_model::ContactModel;

/// Impulse at which the strong motor runs at full speed [N·s] (chosen: 100 g that land at 1 m/s).
const FULL_BLOW: f64 = 0.1;
/// Decay time constant of a collision's rumble [s] (chosen: a small motor takes as long to stop).
const RING_S: f64 = 0.08;

/// Intensities of two rumble motors, each from 0 to 1 [-].
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Rumble {
    /// Slow, strong motor: collisions [-].
    pub strong: f64,
    /// Fast, weak motor: boiling, sliding, scraping [-].
    pub weak: f64,
}

impl Rumble {
    /// Returns the stronger of two for each motor [-].
    #[must_use]
    pub fn or(self, other: Self) -> Self {
        Self { strong: self.strong.max(other.strong), weak: self.weak.max(other.weak) }
    }
}

/// Maps the contact model to rumble intensities [-].
///
/// strong = Σ J/J_full, decaying with a time constant of 80 ms; weak is the amplitude of the vibration over its maximum.
#[derive(Clone, Debug)]
pub struct RumbleRule {
    feel: Feel,
    seen: Option<u64>,
    strong: f64,
}

impl RumbleRule {
    /// Creates a rule without rumble.
    pub fn new(feel: &Feel) -> Self {
        Self { feel: feel.clone(), seen: None, strong: 0.0 }
    }

    /// Returns the rumble of a step of `dt` [s] [-].
    pub fn step(&mut self, model: &ContactModel, dt: f64) -> Rumble {
        self.strong *= libm::exp(-dt / RING_S);
        if model.number > 0 {
            self.strong += self.blows(model);
        }
        self.strong = if self.strong.is_finite() { self.strong.min(1.0) } else { 0.0 };
        Rumble { strong: self.strong, weak: self.weak(model) }
    }

    /// Returns the intensity that new collisions add [-].
    fn blows(&mut self, model: &ContactModel) -> f64 {
        let newest = model.impulses.iter().map(|i| i.number).max().unwrap_or(0);
        // Collisions from before the first model are not rendered.
        let seen = self.seen.replace(newest).unwrap_or(newest);
        let sizes = model.impulses.iter().filter(|i| i.number > seen).map(|i| i.impulse.length());
        sizes.filter(|size| *size >= self.feel.impulse.least_n_s).map(|size| size / FULL_BLOW).sum()
    }

    fn weak(&self, model: &ContactModel) -> f64 {
        let (sizzle, slide) = (&self.feel.sizzle, &self.feel.slide);
        let rubbing = vibration::rubbing(slide, &model.sliding) + vibration::rubbing(slide, &model.scraping);
        let share = (vibration::boiling(sizzle, model.vapour) + rubbing) / (sizzle.force_n + slide.largest_n);
        if share.is_finite() { share.clamp(0.0, 1.0) } else { 0.0 }
    }
}

//! Collisions, sliding and boiling for devices that can only rumble.

use serde::Serialize;

use crate::kitchen::contact_model::ContactModel;
use crate::control::feel::Feel;
use crate::control::vibration;

/// Blow at which the strong motor turns fully [N·s] (chosen: 100 g that land at 1 m/s).
const FULL_BLOW: f64 = 0.1;
/// How long a blow rings [s] (chosen: a small motor takes as long to stop).
const RING_S: f64 = 0.08;

/// How hard motors shake, each from 0 to 1 [-].
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Rumble {
    /// Slow and strong: collisions.
    pub strong: f64,
    /// Fast and weak: boiling, sliding, scraping.
    pub weak: f64,
}

/// Finds the rumble that stands for what a hand should feel: strong = Σ J/J_full, ringing out within 80 ms; weak is the
/// amplitude of the fine vibration over its largest.
#[derive(Clone, Debug)]
pub struct RumbleRule {
    feel: Feel,
    heard: Option<u64>,
    strong: f64,
}

impl RumbleRule {
    /// Still.
    pub fn new(feel: &Feel) -> Self {
        Self { feel: feel.clone(), heard: None, strong: 0.0 }
    }

    /// The rumble in a step of `dt` [s].
    pub fn step(&mut self, model: &ContactModel, dt: f64) -> Rumble {
        self.strong *= libm::exp(-dt / RING_S);
        if model.number > 0 {
            self.strong += self.blows(model);
        }
        self.strong = if self.strong.is_finite() { self.strong.min(1.0) } else { 0.0 };
        Rumble { strong: self.strong, weak: self.weak(model) }
    }

    /// What the collisions add that are new.
    fn blows(&mut self, model: &ContactModel) -> f64 {
        let newest = model.impulses.iter().map(|i| i.number).max().unwrap_or(0);
        // What happened before the hand was there is not felt.
        let heard = self.heard.replace(newest).unwrap_or(newest);
        let sizes = model.impulses.iter().filter(|i| i.number > heard).map(|i| i.impulse.length());
        sizes.filter(|size| *size >= self.feel.impulse.least_n_s).map(|size| size / FULL_BLOW).sum()
    }

    fn weak(&self, model: &ContactModel) -> f64 {
        let (sizzle, slide) = (&self.feel.sizzle, &self.feel.slide);
        let rubbing = vibration::rubbing(slide, &model.sliding) + vibration::rubbing(slide, &model.scraping);
        let share = (vibration::boiling(sizzle, model.vapour) + rubbing) / (sizzle.force_n + slide.largest_n);
        if share.is_finite() { share.clamp(0.0, 1.0) } else { 0.0 }
    }
}

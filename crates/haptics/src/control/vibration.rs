//! Vibration: boiling, sliding and scraping as a force along the pan's axis.

use glam::DVec3;
use saute_kitchen::dynamics::Pose;

use crate::control::feel::{SizzleFeel, SlideFeel};
use crate::kitchen::contact_model::{ContactModel, Rubbing};
use crate::wrench::Wrench;

/// Vibration force along the pan's axis [N].
///
/// Boiling is band-limited noise with an amplitude A ∝ √(vapour flow), because bubbles burst independently. Sliding and
/// scraping are sines of a texture of one pitch, with the frequency speed / pitch.
#[derive(Clone, Debug)]
pub struct Vibration {
    sizzle: SizzleFeel,
    slide: SlideFeel,
    random: u64,
    low: f64,
    high: f64,
    phase: [f64; 2],
}

impl Vibration {
    /// Creates a source without vibration.
    pub fn new(sizzle: &SizzleFeel, slide: &SlideFeel) -> Self {
        Self { sizzle: sizzle.clone(), slide: slide.clone(), random: SEED, low: 0.0, high: 0.0, phase: [0.0; 2] }
    }

    /// Returns the vibration of a step of `dt` [s] [N].
    pub fn step(&mut self, model: &ContactModel, pose: &Pose, dt: f64) -> Wrench {
        let boiling = self.noise(dt) * boiling(&self.sizzle, model.vapour);
        let sliding = self.texture(0, &model.sliding, dt);
        let scraping = self.texture(1, &model.scraping, dt);
        Wrench { force: pose.rotation * DVec3::Z * (boiling + sliding + scraping), torque: DVec3::ZERO }
    }

    /// Returns band-pass noise of about unit amplitude [-].
    fn noise(&mut self, dt: f64) -> f64 {
        self.random ^= self.random << 13;
        self.random ^= self.random >> 7;
        self.random ^= self.random << 17;
        let white = (self.random >> 11) as f64 / (1u64 << 52) as f64 - 1.0;
        let share = |hz: f64| 1.0 - libm::exp(-std::f64::consts::TAU * hz * dt);
        self.high += (white - self.high) * share(self.sizzle.high_hz);
        self.low += (self.high - self.low) * share(self.sizzle.low_hz);
        self.high - self.low
    }

    fn texture(&mut self, which: usize, contact: &Rubbing, dt: f64) -> f64 {
        let amplitude = rubbing(&self.slide, contact);
        if amplitude == 0.0 {
            return 0.0;
        }
        // Above a quarter of the sampling rate a texture would alias; the frequency is limited there.
        let hz = (contact.speed / (self.slide.pitch_mm * 1e-3)).min(0.25 / dt.max(1e-6));
        self.phase[which] = (self.phase[which] + hz * dt).fract();
        amplitude * libm::sin(std::f64::consts::TAU * self.phase[which])
    }
}

/// Returns the force amplitude of boiling at a vapour flow [kg/s] [N].
pub fn boiling(feel: &SizzleFeel, vapour: f64) -> f64 {
    let share = (vapour * 1e3 / feel.at_vapour_g_s).max(0.0);
    feel.force_n * libm::sqrt(share).min(2.0)
}

/// Returns the force amplitude of a rubbing contact [N]; zero below the slowest perceptible speed.
pub fn rubbing(feel: &SlideFeel, rubbing: &Rubbing) -> f64 {
    if rubbing.speed < feel.least_m_s { 0.0 } else { (feel.force_n * rubbing.force).min(feel.largest_n) }
}

/// Seed of the xorshift generator (chosen: any non-zero value works; this is 2⁶⁴ divided by the golden ratio).
const SEED: u64 = 0x9e37_79b9_7f4a_7c15;

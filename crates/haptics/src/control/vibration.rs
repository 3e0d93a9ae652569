//! Sizzle, sliding and scraping as fine vibration.

use glam::DVec3;
use saute_kitchen::dynamics::Pose;

use crate::kitchen::contact_model::{ContactModel, Rubbing};
use crate::control::feel::{SizzleFeel, SlideFeel};
use crate::wrench::Wrench;

/// A force along the pan's axis [N]: band-limited noise for boiling, A ∝ √(vapour flow), since bubbles burst
/// independently; and a texture of one pitch for what rubs, at speed over pitch.
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
    /// Silent.
    pub fn new(sizzle: &SizzleFeel, slide: &SlideFeel) -> Self {
        Self { sizzle: sizzle.clone(), slide: slide.clone(), random: SEED, low: 0.0, high: 0.0, phase: [0.0; 2] }
    }

    /// What is felt in a step of `dt` [s].
    pub fn step(&mut self, model: &ContactModel, pose: &Pose, dt: f64) -> Wrench {
        let boiling = self.noise(dt) * boiling(&self.sizzle, model.vapour);
        let sliding = self.rub(0, &model.sliding, dt);
        let scraping = self.rub(1, &model.scraping, dt);
        Wrench { force: pose.rotation * DVec3::Z * (boiling + sliding + scraping), torque: DVec3::ZERO }
    }

    /// Noise between the band's edges, of about unit amplitude [-].
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

    fn rub(&mut self, which: usize, met: &Rubbing, dt: f64) -> f64 {
        let amplitude = rubbing(&self.slide, met);
        if amplitude == 0.0 {
            return 0.0;
        }
        // Above a quarter of the rate a texture would alias; it is felt as its highest tone.
        let hz = (met.speed / (self.slide.pitch_mm * 1e-3)).min(0.25 / dt.max(1e-6));
        self.phase[which] = (self.phase[which] + hz * dt).fract();
        amplitude * libm::sin(std::f64::consts::TAU * self.phase[which])
    }
}

/// Amplitude of boiling at a flow of vapour [kg/s], as a force [N].
pub fn boiling(feel: &SizzleFeel, vapour: f64) -> f64 {
    let share = (vapour * 1e3 / feel.at_vapour_g_s).max(0.0);
    feel.force_n * libm::sqrt(share).min(2.0)
}

/// Amplitude of what rubs, as a force [N]; none where it is slower than is felt.
pub fn rubbing(feel: &SlideFeel, rubbing: &Rubbing) -> f64 {
    if rubbing.speed < feel.least_m_s { 0.0 } else { (feel.force_n * rubbing.force).min(feel.largest_n) }
}

/// Start of the noise (chosen: any but zero).
const SEED: u64 = 0x9e37_79b9_7f4a_7c15;

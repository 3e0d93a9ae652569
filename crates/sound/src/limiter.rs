//! The limiter: no sample above the ceiling, and no click where it sets in.

use alloc::vec;
use alloc::vec::Vec;

/// The highest sample [-]: −1 dBFS.
pub const CEILING: f32 = 0.891_250_9;
/// How far it looks ahead [s] (chosen: short against the 50 ms from act to sound, long enough to turn down without a click).
const AHEAD_S: f32 = 2e-3;
/// Time in which it turns up again [s] (chosen: shorter pumps, longer hides what follows a blow).
const RELEASE_S: f32 = 0.15;

/// A limiter that looks ahead: the gain of a sample is the mean of the least gains in the time before it, so that it is low enough
/// when the peak comes out.
#[derive(Clone, Debug)]
pub(crate) struct Limiter {
    delayed: Vec<[f32; 2]>,
    /// Gains that the samples on their way need, the one that comes out included.
    needed: Vec<f32>,
    /// The latest gains; their mean is applied.
    held: Vec<f32>,
    sum: f64,
    at: usize,
    needed_at: usize,
    gain: f32,
    release: f32,
}

impl Limiter {
    pub(crate) fn new(rate: f32) -> Self {
        let length = (libm::roundf(AHEAD_S * rate) as usize).max(1);
        Self {
            delayed: vec![[0.0; 2]; length],
            needed: vec![1.0; length + 1],
            held: vec![1.0; length],
            sum: length as f64,
            at: 0,
            needed_at: 0,
            gain: 1.0,
            release: 1.0 - libm::expf(-1.0 / (RELEASE_S * rate)),
        }
    }

    /// Takes a frame, and returns the one from the look-ahead before.
    pub(crate) fn pass(&mut self, frame: [f32; 2]) -> [f32; 2] {
        let peak = libm::fabsf(frame[0]).max(libm::fabsf(frame[1]));
        let out = core::mem::replace(&mut self.delayed[self.at], frame);
        self.needed[self.needed_at] = if peak > CEILING { CEILING / peak } else { 1.0 };
        let gain = self.next_gain();
        self.at = (self.at + 1) % self.delayed.len();
        self.needed_at = (self.needed_at + 1) % self.needed.len();
        out.map(|x| (x * gain).clamp(-CEILING, CEILING))
    }

    fn next_gain(&mut self) -> f32 {
        let least = if self.gain < 1.0 || self.needed[self.needed_at] < 1.0 { self.least() } else { 1.0 };
        self.gain = least.min(self.gain + (1.0 - self.gain) * self.release);
        // Close to 1 is 1: below that it would stay on its way for ever.
        if self.gain > 0.9999 && least == 1.0 {
            self.gain = 1.0;
        }
        self.sum += f64::from(self.gain) - f64::from(self.held[self.at]);
        self.held[self.at] = self.gain;
        (self.sum / self.held.len() as f64) as f32
    }

    fn least(&self) -> f32 {
        self.needed.iter().copied().fold(1.0, f32::min)
    }
}

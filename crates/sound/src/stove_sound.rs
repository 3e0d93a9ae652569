//! The sound of a stove: the roar and hiss of a gas flame, the hum of an induction coil.

use core::f32::consts::TAU;

use crate::glide::Smooth;
use crate::hiss::Noise;
use crate::random::Random;
use crate::stove::Stove;

/// The roar of the flame and the hiss of its jets: centres [Hz], qualities [-], and the share of the roar [-] (chosen).
const ROAR: (f32, f32) = (380.0, 0.6);
const JETS: (f32, f32) = (3200.0, 0.6);
const ROARS: f32 = 0.6;
/// Twice the frequency of the mains, with which the force on the pan's floor swings [Hz] (chosen: that of 50 Hz).
const HUM_HZ: f32 = 100.0;
/// Amplitudes of the hum and its overtones [-] (chosen: a buzz), and the mean square of their sum.
const OVERTONES: [f32; 5] = [1.0, 0.8, 0.5, 0.35, 0.2];
const OVERTONES_SQUARE: f32 = 0.5 * (1.0 + 0.64 + 0.25 + 0.1225 + 0.04);
/// Time in which the hum follows the power [s].
const GAIN_S: f32 = 0.02;

/// The sound of a stove.
#[derive(Clone, Debug)]
pub(crate) struct StoveSound {
    roar: Noise,
    jets: Noise,
    noise: Random,
    /// Where the hum is in its period, as a point of the unit circle, and its turn in a sample.
    at: [f32; 2],
    turn: [f32; 2],
    hum: Smooth,
    loud: f32,
    rate: f32,
}

impl StoveSound {
    pub(crate) fn new(noise: Random, rate: f32) -> Self {
        let angle = TAU * HUM_HZ / rate;
        Self {
            roar: Noise::new(ROAR.0, ROAR.1, rate),
            jets: Noise::new(JETS.0, JETS.1, rate),
            noise,
            at: [1.0, 0.0],
            turn: [libm::cosf(angle), libm::sinf(angle)],
            hum: Smooth::over(GAIN_S, rate),
            loud: 0.0,
            rate,
        }
    }

    /// Sets how a stove heats, and with how much power [W].
    pub(crate) fn set(&mut self, stove: Stove, drawn_w: f32) {
        let power_of = |kind| if stove == kind { stove.loudness(drawn_w) } else { 0.0 };
        let flame = power_of(Stove::Flame);
        self.roar.set(ROARS * flame, ROAR.0, self.rate);
        self.jets.set((1.0 - ROARS) * flame, JETS.0, self.rate);
        self.loud = libm::sqrtf(power_of(Stove::Coil) / OVERTONES_SQUARE);
    }

    /// Keeps the point on the circle.
    pub(crate) fn control(&mut self) {
        let [x, y] = self.at;
        let length = libm::sqrtf(x * x + y * y);
        self.at = [x / length, y / length];
    }

    /// Returns the next frame.
    pub(crate) fn next(&mut self) -> [f32; 2] {
        let hum = self.hum();
        if self.roar.is_silent() && self.jets.is_silent() {
            return [hum; 2];
        }
        let white = [self.noise.white(), self.noise.white()];
        let (roar, jets) = (self.roar.next(white), self.jets.next(white));
        [roar[0] + jets[0] + hum, roar[1] + jets[1] + hum]
    }

    fn hum(&mut self) -> f32 {
        let gain = self.hum.follow(self.loud);
        if gain == 0.0 {
            return 0.0;
        }
        let times = |[a, b]: [f32; 2], [c, d]: [f32; 2]| [a * c - b * d, a * d + b * c];
        self.at = times(self.at, self.turn);
        let mut overtone = [1.0, 0.0];
        let sum = OVERTONES.iter().fold(0.0, |sum, amplitude| {
            overtone = times(overtone, self.at);
            sum + amplitude * overtone[1]
        });
        gain * sum
    }
}

//! A string drive: one motor with its encoder and string.

use crate::random::Random;
use crate::rig_file::Drive;

/// Time constant of the motor current [s] (chosen: a small coreless motor with a current controller).
const CURRENT_LAG_S: f64 = 1.2e-3;
/// Coulomb friction of pulley and guide, as tension [N] (chosen: a ball-bearing pulley and a ceramic eye).
const FRICTION_N: f64 = 0.02;
/// Speed scale of the friction's sign change [m/s] (chosen: slow against hand motion, and smooth at the step length).
const REVERSAL: f64 = 0.01;
/// Relative error of the string stiffness [-] (chosen: a tenth, typical of braided line).
const STIFFNESS_ERROR: f64 = 0.1;

/// State of a string drive.
#[derive(Clone, Copy, Debug)]
pub struct StringDrive {
    min: f64,
    max: f64,
    pitch: f64,
    stiffness: f64,
    friction: f64,
    wanted: f64,
    motor: f64,
    tension: f64,
    /// Unstretched length at which the encoder counts 0 [m].
    zero: f64,
    unstretched: f64,
    length: f64,
}

impl StringDrive {
    /// Creates a drive at rest with a string length [m]; the encoder counts from a random zero. `noise` multiplies friction and
    /// the error of the stiffness.
    pub fn new(drive: &Drive, length: f64, noise: f64, random: &mut Random) -> Self {
        let stiffness = drive.axial_stiffness_n * (1.0 + noise * STIFFNESS_ERROR * random.signed()).max(0.1);
        Self {
            min: drive.min_tension_n,
            max: drive.max_tension_n,
            pitch: drive.encoder_pitch_um * 1e-6,
            stiffness,
            friction: noise * FRICTION_N,
            wanted: 0.0,
            motor: 0.0,
            tension: 0.0,
            zero: length + 0.05 * random.signed(),
            unstretched: length,
            length,
        }
    }

    /// Sets the commanded tension [N]; one outside the drive's range becomes the nearest within it.
    pub fn command(&mut self, tension: f64) {
        self.wanted = tension.clamp(self.min, self.max);
    }

    /// Commands the minimum tension.
    pub fn idle(&mut self) {
        self.wanted = self.min;
    }

    /// Commands zero tension.
    pub fn release(&mut self) {
        self.wanted = 0.0;
    }

    /// Simulates the loss of the encoder's count.
    pub fn lose_count(&mut self, random: &mut Random) {
        self.zero = self.unstretched + 0.05 * random.signed();
    }

    /// Advances by `dt` [s] to a new string length [m].
    pub fn step(&mut self, length: f64, dt: f64) {
        self.motor += (self.wanted - self.motor) * (1.0 - libm::exp(-dt / CURRENT_LAG_S));
        let winding_in = (self.length - length) / dt;
        self.tension = (self.motor - self.friction * libm::tanh(winding_in / REVERSAL)).max(0.0);
        self.length = length;
        self.unstretched = length / (1.0 + self.tension / self.stiffness);
    }

    /// Returns the tension at the pan [N].
    pub fn tension(&self) -> f64 {
        self.tension
    }

    /// Returns the tension derived from the motor current [N].
    pub fn by_current(&self) -> f64 {
        self.motor
    }

    /// Returns the encoder count, with a jitter in counts.
    pub fn count(&self, jitter: f64) -> i32 {
        libm::floor((self.unstretched - self.zero) / self.pitch + jitter) as i32
    }
}

//! A stream of liquid that is poured: bubbles that it draws in.

use crate::bubbles::{Bubble, Bubbles, radius};
use crate::random::Random;

/// How long a stream is heard [s] (chosen: a small cup is emptied).
const LASTS_S: f32 = 0.7;
/// Bubbles that it draws in [1/s] (chosen: a thin stream).
const RATE: f32 = 90.0;
/// Their radii [m] (chosen: 0.8 to 2.7 kHz).
const RADIUS_M: [f32; 2] = [1.2e-3, 4e-3];
/// Amplitude of one at strength 1 [-] (chosen).
const AMPLITUDE: f32 = 0.05;

/// A stream while it lasts.
#[derive(Clone, Debug)]
pub(crate) struct Pour {
    random: Random,
    left_s: f32,
    strength: f32,
    wait_s: f32,
}

impl Pour {
    pub(crate) fn new(random: Random) -> Self {
        Self { random, left_s: 0.0, strength: 0.0, wait_s: 0.0 }
    }

    /// Begins a stream.
    pub(crate) fn begin(&mut self, strength: f32) {
        (self.left_s, self.strength) = (LASTS_S, strength);
    }

    /// Goes on for a time [s] and starts the bubbles that are due.
    pub(crate) fn go_on(&mut self, time_s: f32, bubbles: &mut Bubbles) {
        if self.left_s <= 0.0 {
            return;
        }
        self.left_s -= time_s;
        self.wait_s -= time_s;
        while self.wait_s < 0.0 {
            self.wait_s += self.random.exponential() / RATE;
            bubbles.start(&Bubble {
                radius_m: radius(&mut self.random, RADIUS_M),
                amplitude: AMPLITUDE * self.strength * self.random.share(),
                damped: 1.0,
                side: 0.3 * self.random.even(),
            });
        }
    }
}

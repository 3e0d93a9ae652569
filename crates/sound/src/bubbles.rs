//! Single bubbles: each rings at the frequency of Minnaert, rises in pitch as it nears the surface, and dies away.

use alloc::vec::Vec;
use core::f32::consts::{FRAC_PI_4, PI};

use crate::random::Random;

/// Largest number of bubbles that ring at once [-].
const MOST: usize = 64;
/// Frequency times radius [m·Hz]: (1/2π)·√(3γp/ρ) of a bubble in water at 1 bar (`[@minnaert-1933]`). In hot oil it is 3.4 (γ = 1.3,
/// ρ = 850 kg/m³), four per cent more, which is not distinguished.
const MINNAERT: f32 = 3.26;
/// Damping 0.13/R + 0.0072·R^(−3/2) [1/s] (`[@van-den-doel-2005]`, recalled): 5 to 20 periods from 0.3 to 3 mm.
const DAMPING: [f32; 2] = [0.13, 0.0072];
/// Rise of the pitch over the damping [-] (`[@van-den-doel-2005]`, recalled: 0.1 sounds like drops).
const RISE: f32 = 0.1;
/// Highest frequency over the sample rate [-] (chosen: below the half, with room for the rise).
const HIGHEST: f32 = 0.4;
/// Amplitude at which a bubble is given up [-] (chosen: −110 dB).
const LEAST: f32 = 3e-6;

/// A bubble as it is heard.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bubble {
    /// Radius [m].
    pub(crate) radius_m: f32,
    /// Amplitude at its beginning [-].
    pub(crate) amplitude: f32,
    /// Damping over that of a bubble wholly in the liquid [-].
    pub(crate) damped: f32,
    /// Place from left (−1) to right (1) [-].
    pub(crate) side: f32,
}

impl Bubble {
    /// Damping [1/s].
    pub(crate) fn damping(&self) -> f32 {
        let r = self.radius_m;
        self.damped * (DAMPING[0] / r + DAMPING[1] / (r * libm::sqrtf(r)))
    }
}

/// Returns a radius between two, evenly spread over octaves [m].
pub(crate) fn radius(random: &mut Random, [least, most]: [f32; 2]) -> f32 {
    least * libm::powf(most / least, random.share())
}

/// A bubble that rings: a pointer that turns, ever faster, and shrinks.
#[derive(Clone, Copy, Debug)]
struct Voice {
    pointer: [f32; 2],
    turn: [f32; 2],
    chirp: [f32; 2],
    gains: [f32; 2],
}

fn times(a: [f32; 2], b: [f32; 2]) -> [f32; 2] {
    [a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]]
}

impl Voice {
    fn of(bubble: &Bubble, rate: f32) -> Self {
        let damping = bubble.damping();
        let hz = (MINNAERT / bubble.radius_m).min(HIGHEST * rate);
        let angle = 2.0 * PI * hz / rate;
        let shrink = libm::expf(-damping / rate);
        let faster = angle * RISE * damping / bubble.damped / rate;
        // Equal power on the way from left to right.
        let pan = FRAC_PI_4 * (1.0 + bubble.side);
        Self {
            pointer: [bubble.amplitude, 0.0],
            turn: [shrink * libm::cosf(angle), shrink * libm::sinf(angle)],
            chirp: [libm::cosf(faster), libm::sinf(faster)],
            gains: [libm::cosf(pan), libm::sinf(pan)].map(|g| core::f32::consts::SQRT_2 * g),
        }
    }

    fn next(&mut self) -> f32 {
        self.pointer = times(self.pointer, self.turn);
        self.turn = times(self.turn, self.chirp);
        self.pointer[1]
    }

    fn is_over(&self) -> bool {
        self.pointer[0] * self.pointer[0] + self.pointer[1] * self.pointer[1] < LEAST * LEAST
    }
}

/// All bubbles that ring.
#[derive(Clone, Debug)]
pub(crate) struct Bubbles {
    voices: Vec<Voice>,
    rate: f32,
}

impl Bubbles {
    pub(crate) fn new(rate: f32) -> Self {
        Self { voices: Vec::with_capacity(MOST), rate }
    }

    /// Starts a bubble, unless as many ring as may.
    pub(crate) fn start(&mut self, bubble: &Bubble) {
        if self.voices.len() < MOST {
            self.voices.push(Voice::of(bubble, self.rate));
        }
    }

    /// Returns the next frame.
    pub(crate) fn next(&mut self) -> [f32; 2] {
        let mut frame = [0.0; 2];
        for voice in &mut self.voices {
            let x = voice.next();
            frame[0] += voice.gains[0] * x;
            frame[1] += voice.gains[1] * x;
        }
        frame
    }

    /// Gives up those that are no longer heard.
    pub(crate) fn clear_out(&mut self) {
        self.voices.retain(|voice| !voice.is_over());
    }
}

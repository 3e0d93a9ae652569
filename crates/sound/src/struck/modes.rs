//! A body that rings: its modes as damped resonators, driven by a force.

use alloc::vec::Vec;
use core::f32::consts::PI;

/// A mode of a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Mode {
    /// Frequency [Hz].
    pub(crate) hz: f32,
    /// Quality when nothing damps it from without [-].
    pub(crate) quality: f32,
    /// How much of a blow it takes up and sends out [-].
    pub(crate) weight: f32,
}

/// A mode as a pointer that turns and shrinks.
#[derive(Clone, Copy, Debug)]
struct Resonator {
    mode: Mode,
    pointer: [f32; 2],
    turn: [f32; 2],
}

/// Highest frequency over the sample rate [-] (chosen: what is above is left out).
const HIGHEST: f32 = 0.42;
/// Amplitude at which a body is at rest [-] (chosen: −120 dB).
const AT_REST: f32 = 1e-6;

/// The modes of a body.
#[derive(Clone, Debug)]
pub(crate) struct Modes {
    resonators: Vec<Resonator>,
    rate: f32,
    is_awake: bool,
}

impl Modes {
    /// Returns a body at rest; its weights are scaled so that they sum to 1.
    pub(crate) fn new(modes: impl Iterator<Item = Mode> + Clone, rate: f32) -> Self {
        let whole: f32 = modes.clone().map(|mode| mode.weight).sum();
        let audible = modes.filter(|mode| mode.hz < HIGHEST * rate);
        let resonators = audible.map(|mode| Resonator {
            mode: Mode { weight: mode.weight / whole, ..mode },
            pointer: [0.0; 2],
            turn: [0.0; 2],
        });
        let mut body = Self { resonators: resonators.collect(), rate, is_awake: false };
        body.damp(0.0);
        body
    }

    /// Damps the body from without, by a loss 1/Q [-] that adds to that of each mode. What rings goes on.
    pub(crate) fn damp(&mut self, loss: f32) {
        for resonator in &mut self.resonators {
            let Mode { hz, quality, .. } = resonator.mode;
            let angle = 2.0 * PI * hz / self.rate;
            // The amplitude falls with π·f/Q.
            let shrink = libm::expf(-0.5 * angle * (1.0 / quality + loss));
            resonator.turn = [shrink * libm::cosf(angle), shrink * libm::sinf(angle)];
        }
    }

    /// Returns the next sample under a force.
    pub(crate) fn next(&mut self, force: f32) -> f32 {
        if force == 0.0 && !self.is_awake {
            return 0.0;
        }
        self.is_awake = true;
        let mut sum = 0.0;
        for Resonator { mode, pointer, turn } in &mut self.resonators {
            let [re, im] = *pointer;
            *pointer = [re * turn[0] - im * turn[1] + force * mode.weight, re * turn[1] + im * turn[0]];
            sum += pointer[1];
        }
        sum
    }

    /// Lets the body sleep once it no longer rings.
    pub(crate) fn settle(&mut self) {
        let moves = |r: &Resonator| libm::fabsf(r.pointer[0]) + libm::fabsf(r.pointer[1]) > AT_REST;
        if self.is_awake && !self.resonators.iter().any(moves) {
            self.resonators.iter_mut().for_each(|r| r.pointer = [0.0; 2]);
            self.is_awake = false;
        }
    }
}

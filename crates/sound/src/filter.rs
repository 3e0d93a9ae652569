//! Filters: a band of noise, and a slope.

use core::f32::consts::PI;

/// Highest corner over the sample rate [-] (chosen: the tangent of the bilinear transform stays moderate).
const HIGHEST: f32 = 0.4;

/// A state-variable filter for two channels in the trapezoidal form (Zavalishin 2012; Simper 2013), which is stable while its
/// corner moves.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Band {
    k: f32,
    a: [f32; 3],
    state: [[f32; 2]; 2],
}

impl Band {
    /// A filter at a centre [Hz] with a quality [-] for a sample rate [Hz].
    pub(crate) fn new(hz: f32, quality: f32, rate: f32) -> Self {
        let mut band = Self { k: 1.0 / quality, a: [0.0; 3], state: [[0.0; 2]; 2] };
        band.tune(hz, rate);
        band
    }

    /// Moves the centre [Hz]; what rings in it goes on.
    pub(crate) fn tune(&mut self, hz: f32, rate: f32) {
        let g = libm::tanf(PI * (hz / rate).min(HIGHEST));
        let whole = 1.0 / (1.0 + g * (g + self.k));
        self.a = [whole, g * whole, g * g * whole];
    }

    /// Forgets what rings.
    pub(crate) fn rest(&mut self) {
        self.state = [[0.0; 2]; 2];
    }

    /// Returns the band-pass output, 1 at the centre.
    pub(crate) fn pass(&mut self, frame: [f32; 2]) -> [f32; 2] {
        let Self { k, a, state } = self;
        let mut out = [0.0; 2];
        for ((out, x), [s1, s2]) in out.iter_mut().zip(frame).zip(state) {
            let v3 = x - *s2;
            let v1 = a[0] * *s1 + a[1] * v3;
            let v2 = *s2 + a[1] * *s1 + a[2] * v3;
            *s1 = 2.0 * v1 - *s1;
            *s2 = 2.0 * v2 - *s2;
            *out = *k * v1;
        }
        out
    }
}

/// A first-order low-pass in the trapezoidal form.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Slope {
    share: f32,
    state: f32,
}

impl Slope {
    /// A filter with a corner [Hz] for a sample rate [Hz].
    pub(crate) fn new(hz: f32, rate: f32) -> Self {
        let g = libm::tanf(PI * (hz / rate).min(HIGHEST));
        Self { share: g / (1.0 + g), state: 0.0 }
    }

    /// Returns what is below the corner.
    pub(crate) fn low(&mut self, x: f32) -> f32 {
        let v = (x - self.state) * self.share;
        let low = v + self.state;
        self.state = low + v;
        low
    }

    /// Forgets what went before if it is too weak to be heard.
    pub(crate) fn settle(&mut self, least: f32) {
        if libm::fabsf(self.state) < least {
            self.state = 0.0;
        }
    }
}

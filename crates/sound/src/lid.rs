//! The lid as a wall for sound: what is in the pan loses its highs.

use crate::filter::Slope;
use crate::glide::Smooth;

/// Corner above which a lid lets less through [Hz] (chosen: a wall that is moved by its mass lets 6 dB less through for each
/// octave; a glass lid leaks at its rim, so that what is lower comes out).
const CORNER_HZ: f32 = 700.0;
/// What of the lows comes out [-] (chosen: −1 dB).
const LEAKS: f32 = 0.89;
/// Time in which the lid opens or closes [s] (chosen: a hand lays it on).
const LAYS_ON_S: f32 = 0.12;
/// Amplitude that counts as silence [-] (chosen: −140 dB).
const SILENT: f32 = 1e-7;

/// Power that comes out of that at a frequency [Hz] [-].
pub(crate) fn through(hz: f32) -> f32 {
    LEAKS * LEAKS / (1.0 + (hz / CORNER_HZ) * (hz / CORNER_HZ))
}

/// The lid's effect on both channels.
#[derive(Clone, Debug)]
pub(crate) struct LidFilter {
    slopes: [Slope; 2],
    closed: Smooth,
}

impl LidFilter {
    pub(crate) fn new(rate: f32) -> Self {
        Self { slopes: [Slope::new(CORNER_HZ, rate); 2], closed: Smooth::over(LAYS_ON_S, rate) }
    }

    /// Returns what is heard of a frame from within the pan.
    pub(crate) fn pass(&mut self, frame: [f32; 2], is_on: bool) -> [f32; 2] {
        let closed = self.closed.follow(f32::from(u8::from(is_on)));
        let mut out = frame;
        for (x, slope) in out.iter_mut().zip(&mut self.slopes) {
            let low = LEAKS * slope.low(*x);
            if *x == 0.0 {
                slope.settle(SILENT);
            }
            *x += closed * (low - *x);
        }
        out
    }
}

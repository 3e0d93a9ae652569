//! What is measured of samples: levels by the ear's weighting and by bands, kurtosis, second differences.

use std::f64::consts::PI;

use saute_heat::sorted::{Quantile, Sorted};

/// A biquad filter in double precision (Bristow-Johnson's cookbook).
#[derive(Clone, Copy)]
struct Biquad {
    b: [f64; 3],
    a: [f64; 2],
}

enum Kind {
    Low,
    High,
}

impl Biquad {
    fn new(kind: Kind, hz: f64, quality: f64, rate: f64) -> Self {
        let w = 2.0 * PI * hz / rate;
        let (alpha, cos) = (w.sin() / (2.0 * quality), w.cos());
        let middle = match kind {
            Kind::Low => 1.0 - cos,
            Kind::High => -(1.0 + cos),
        };
        let outer = 0.5 * middle.abs();
        let scale = 1.0 + alpha;
        Self { b: [outer, middle, outer].map(|b| b / scale), a: [-2.0 * cos / scale, (1.0 - alpha) / scale] }
    }

    fn pass(&self, samples: &[f64]) -> Vec<f64> {
        let (mut x, mut y) = ([0.0; 2], [0.0; 2]);
        let next = |&now: &f64| {
            let out = self.b[0] * now + self.b[1] * x[0] + self.b[2] * x[1] - self.a[0] * y[0] - self.a[1] * y[1];
            (x, y) = ([now, x[0]], [out, y[0]]);
            out
        };
        samples.iter().map(next).collect()
    }
}

/// The middle of both channels.
pub fn mono(frames: &[[f32; 2]]) -> Vec<f64> {
    frames.iter().map(|[left, right]| 0.5 * (f64::from(*left) + f64::from(*right))).collect()
}

/// Root mean square as a level [dBFS].
pub fn level(samples: &[f64]) -> f64 {
    10.0 * (samples.iter().map(|x| x * x).sum::<f64>() / samples.len() as f64).max(1e-30).log10()
}

/// What is between two frequencies [Hz]: Butterworth filters of fourth order.
pub fn band(samples: &[f64], [low, high]: [f64; 2], rate: f64) -> Vec<f64> {
    let mut out = samples.to_vec();
    for quality in [0.541_196, 1.306_563] {
        if low > 0.0 {
            out = Biquad::new(Kind::High, low, quality, rate).pass(&out);
        }
        if high < 0.45 * rate {
            out = Biquad::new(Kind::Low, high, quality, rate).pass(&out);
        }
    }
    out
}

/// A-weighted samples: the poles of IEC 61672 at 20.6 Hz (twice), 107.7, 737.9 and 12194 Hz (twice), 0 dB at 1 kHz.
pub fn weighted(samples: &[f64], rate: f64) -> Vec<f64> {
    let first = |samples: &[f64], hz: f64, is_high: bool| -> Vec<f64> {
        let g = (PI * (hz / rate).min(0.45)).tan();
        let mut state = 0.0;
        let next = |&x: &f64| {
            let v = (x - state) * g / (1.0 + g);
            let low = v + state;
            state = low + v;
            if is_high { x - low } else { low }
        };
        samples.iter().map(next).collect()
    };
    let mut out = samples.to_vec();
    for hz in [20.598_997, 20.598_997, 107.652_65, 737.862_23] {
        out = first(&out, hz, true);
    }
    for hz in [12_194.217, 12_194.217] {
        out = first(&out, hz, false);
    }
    // 2.0 dB: what the filters take at 1 kHz.
    out.iter().map(|x| x * 1.258_9).collect()
}

/// Level of each second by the ear's weighting [dB(A) below full scale].
pub fn levels_by_second(frames: &[[f32; 2]], rate: f64) -> Vec<f64> {
    weighted(&mono(frames), rate).chunks_exact(rate as usize).map(level).collect()
}

/// Excess kurtosis between 1 and 12 kHz [-]: 0 for hiss, far above for crackle.
pub fn kurtosis(frames: &[[f32; 2]], rate: f64) -> f64 {
    let heard = band(&mono(frames), [1e3, 12e3], rate);
    let mean = |power: i32| heard.iter().map(|x| x.powi(power)).sum::<f64>() / heard.len() as f64;
    mean(4) / mean(2).powi(2) - 3.0
}

/// Centre of gravity of the power between 50 Hz and 16 kHz, by third octaves [Hz].
pub fn centroid(frames: &[[f32; 2]], rate: f64) -> f64 {
    let samples = mono(frames);
    let (mut sum, mut whole) = (0.0, 0.0);
    for third in -13..=12 {
        let hz = 1e3 * 2f64.powf(f64::from(third) / 3.0);
        let power = 10f64.powf(0.1 * level(&band(&samples, [hz / 1.1225, hz * 1.1225], rate)));
        (sum, whole) = (sum + hz * power, whole + power);
    }
    sum / whole
}

/// Sizes of the second differences of the left channel [-].
pub fn bends(frames: &[[f32; 2]]) -> Vec<f64> {
    frames.windows(3).map(|w| (f64::from(w[0][0]) - 2.0 * f64::from(w[1][0]) + f64::from(w[2][0])).abs()).collect()
}

/// The value that a share of the values does not exceed.
pub fn quantile(values: &[f64], share: f64) -> f64 {
    Sorted::new(values.to_vec()).quantile(share, Quantile::Below).expect("values")
}

/// Rank correlation of Spearman [-].
pub fn spearman(a: &[f64], b: &[f64]) -> f64 {
    let ranks = |values: &[f64]| -> Vec<f64> {
        values.iter().map(|x| values.iter().filter(|y| *y < x).count() as f64).collect()
    };
    let (a, b) = (ranks(a), ranks(b));
    let mean = |v: &[f64]| v.iter().sum::<f64>() / v.len() as f64;
    let (ma, mb) = (mean(&a), mean(&b));
    let dot = |x: &[f64], mx: f64, y: &[f64], my: f64| x.iter().zip(y).map(|(x, y)| (x - mx) * (y - my)).sum::<f64>();
    dot(&a, ma, &b, mb) / (dot(&a, ma, &a, ma) * dot(&b, mb, &b, mb)).sqrt()
}

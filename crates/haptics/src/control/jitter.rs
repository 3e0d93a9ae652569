//! How late the loop's steps begin.

use serde::Serialize;

/// Microseconds that are told apart; later ones count as the last.
const BINS: usize = 20_000;

/// A histogram of lateness.
#[derive(Clone, Debug)]
pub struct Jitter {
    bins: Vec<u32>,
    count: u64,
    max: f64,
}

/// Lateness of steps [µs].
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Lateness {
    /// Half of the steps begin no later.
    pub p50: f64,
    /// 99 of 100 steps begin no later.
    pub p99: f64,
    /// The latest.
    pub max: f64,
}

impl Default for Jitter {
    fn default() -> Self {
        Self { bins: vec![0; BINS], count: 0, max: 0.0 }
    }
}

impl Jitter {
    /// Notes one step that began so late [µs].
    pub fn note(&mut self, late_us: f64) {
        let bin = (late_us.max(0.0) as usize).min(BINS - 1);
        self.bins[bin] += 1;
        self.count += 1;
        self.max = self.max.max(late_us);
    }

    /// Steps so far.
    pub fn count(&self) -> u64 {
        self.count
    }

    /// What was noted.
    pub fn lateness(&self) -> Lateness {
        Lateness { p50: self.quantile(0.5), p99: self.quantile(0.99), max: self.max }
    }

    /// Upper edge of the bin within which a share of the steps lies [µs].
    fn quantile(&self, share: f64) -> f64 {
        let wanted = (share * self.count as f64).ceil() as u64;
        let mut sum = 0;
        for (bin, count) in self.bins.iter().enumerate() {
            sum += u64::from(*count);
            if sum >= wanted && sum > 0 {
                return (bin + 1) as f64;
            }
        }
        0.0
    }
}

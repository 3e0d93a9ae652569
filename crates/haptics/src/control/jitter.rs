//! Jitter of the control loop: how late its steps begin.

use serde::Serialize;

/// Bins of one microsecond each; later steps count in the last bin (chosen: twenty periods at 1 kHz).
const BINS: usize = 20_000;

/// A histogram of lateness [µs].
#[derive(Clone, Debug)]
pub struct Jitter {
    bins: Vec<u32>,
    count: u64,
    max: f64,
}

/// Quantiles of the steps' lateness [µs].
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Lateness {
    /// Median [µs].
    pub p50: f64,
    /// 99th percentile [µs].
    pub p99: f64,
    /// Maximum [µs].
    pub max: f64,
}

impl Default for Jitter {
    fn default() -> Self {
        Self { bins: vec![0; BINS], count: 0, max: 0.0 }
    }
}

impl Jitter {
    /// Records the lateness of one step [µs].
    pub fn note(&mut self, late_us: f64) {
        let bin = (late_us.max(0.0) as usize).min(BINS - 1);
        self.bins[bin] += 1;
        self.count += 1;
        self.max = self.max.max(late_us);
    }

    /// Returns the number of steps so far.
    pub fn count(&self) -> u64 {
        self.count
    }

    /// Returns the quantiles of all steps so far [µs].
    pub fn lateness(&self) -> Lateness {
        Lateness { p50: self.quantile(0.5), p99: self.quantile(0.99), max: self.max }
    }

    /// Returns the upper edge of the bin that completes a share of the steps [µs]. It counts bins, since the loop keeps no list of
    /// values, which would grow.
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

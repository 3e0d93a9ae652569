//! The bootstrap interval of a median.

use saute_kitchen::heat::sorted::{Quantile, Sorted};
use serde::Serialize;

use crate::random::Random;

/// Share of the draws in an interval [-].
pub const INTERVAL: f64 = 0.9;
/// Draws of a bootstrap (chosen: the ends of the interval repeat to a few per cent of its width).
const DRAWS: usize = 2000;

/// A median with its interval.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Interval {
    /// The median.
    pub median: f64,
    /// Lower end of the interval.
    pub low: f64,
    /// Upper end of the interval.
    pub high: f64,
}

impl Interval {
    /// The median of values with its bootstrap interval; none without values. One value has no width.
    pub fn of(values: &[f64], seeds: &[u64]) -> Option<Self> {
        let median = Sorted::new(values.to_vec()).median()?;
        let mut random = Random::new(seeds);
        let drawn = (0..DRAWS).filter_map(|_| {
            let drawn = values.iter().map(|_| values[random.place(values.len())]).collect();
            Sorted::new(drawn).median()
        });
        let medians = Sorted::new(drawn.collect());
        let tail = (1.0 - INTERVAL) / 2.0;
        let [low, high] = [tail, 1.0 - tail].map(|share| medians.quantile(share, Quantile::Linear));
        Some(Self { median, low: low?, high: high? })
    }
}

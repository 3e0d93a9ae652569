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
    pub(super) fn of(values: &[f64], seeds: &[u64]) -> Option<Self> {
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_interval_holds_its_median_repeats_and_narrows_with_the_values() {
        let spread = |count: usize| (0..count).map(|i| (i * 37 % 101) as f64).collect::<Vec<f64>>();
        let (few, many) = (spread(8), spread(101));
        let [few, many] = [few, many].map(|values| Interval::of(&values, &[1]).expect("values"));
        assert!(few.low <= few.median && few.median <= few.high);
        assert!(many.high - many.low < 0.6 * (few.high - few.low), "{few:?} {many:?}");
        assert_eq!(Interval::of(&spread(8), &[1]), Some(few));
        let one = Interval::of(&[7.0], &[1]).expect("a value");
        assert_eq!([one.low, one.median, one.high], [7.0; 3]);
    }

    /// The median of a normal sample of 25 has a standard error of 1.2533/√25 = 0.25: a 90 % interval is 0.82 wide.
    #[test]
    fn an_interval_is_as_wide_as_theory_says() {
        let mut random = Random::new(&[5]);
        let widths: Vec<f64> = (0..60)
            .map(|k| {
                let sample: Vec<f64> = (0..25).map(|_| random.normal()).collect();
                let interval = Interval::of(&sample, &[k]).expect("values");
                interval.high - interval.low
            })
            .collect();
        let mean = widths.iter().sum::<f64>() / 60.0;
        assert!((0.7..1.0).contains(&mean), "{mean}");
    }
}

//! The bootstrap interval of a median.

use serde::Serialize;

use crate::median::median;
use crate::random::Random;

/// Share of the draws that an interval holds [-].
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
        let median = median(values)?;
        let mut random = Random::new(seeds);
        let mut medians: Vec<f64> = (0..DRAWS)
            .filter_map(|_| {
                let drawn: Vec<f64> = values.iter().map(|_| values[random.place(values.len())]).collect();
                crate::median::median(&drawn)
            })
            .collect();
        medians.sort_by(f64::total_cmp);
        let tail = (1.0 - INTERVAL) / 2.0;
        Some(Self { median, low: quantile(&medians, tail), high: quantile(&medians, 1.0 - tail) })
    }
}

/// A quantile of sorted values, linear between them.
fn quantile(sorted: &[f64], share: f64) -> f64 {
    let at = share * (sorted.len() - 1) as f64;
    let (low, high) = (sorted[libm::floor(at) as usize], sorted[libm::ceil(at) as usize]);
    low + (at - libm::floor(at)) * (high - low)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_median_has_half_of_the_values_on_either_side() {
        assert_eq!(median(&[3.0, 1.0, 2.0]), Some(2.0));
        assert_eq!(median(&[4.0, 1.0, 2.0, 3.0]), Some(2.5));
        assert_eq!(median(&[]), None);
    }

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

//! Promise: the bootstrap interval of a median is as wide as theory says, and repeats.

use saute_kitchen::food::tissue::noise::uniform;
use saute_study::analysis::Interval;

/// A number of a normal distribution, as good as twelve uniform ones add up to one.
fn normal(number: u64) -> f64 {
    (0..12).map(|k| uniform(5, 12 * number + k)).sum::<f64>() - 6.0
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
    let widths: Vec<f64> = (0..60)
        .map(|k| {
            let sample: Vec<f64> = (0..25).map(|n| normal(25 * k + n)).collect();
            let interval = Interval::of(&sample, &[k]).expect("values");
            interval.high - interval.low
        })
        .collect();
    let mean = widths.iter().sum::<f64>() / 60.0;
    assert!((0.7..1.0).contains(&mean), "{mean}");
}

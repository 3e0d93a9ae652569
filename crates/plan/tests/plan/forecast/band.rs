//! Promise: as many forecasts as `data/forecast.toml` states are within the band, and its numbers are those of the campaign.

use saute_kitchen::Library;
use saute_kitchen::heat::sorted::{Quantile, Sorted};
use saute_plan::forecast::{Bands, Question, SPANS_S};

use super::comparison::{Case, Miss};

/// Cases of the campaign; each answers up to four questions.
const CAMPAIGN: std::ops::RangeInclusive<u64> = 1..=40;
/// Cases of the test: none of the campaign, three with four questions each.
const OTHERS: std::ops::RangeInclusive<u64> = 101..=103;

/// Numbers of a comparison that have a band: the core at each span, and the peak.
const NUMBERS: usize = SPANS_S.len() + 1;

fn numbers(miss: &Miss) -> [Option<f64>; NUMBERS] {
    core::array::from_fn(|i| miss.cores.get(i).copied().or(miss.peak).map(f64::abs))
}

fn misses(cases: impl Iterator<Item = u64>) -> Vec<Miss> {
    let library = Library::embedded().unwrap();
    let compared = cases.flat_map(|number| {
        let case = Case::numbered(number);
        println!("{case:?}");
        let misses = case.misses(&library);
        for Miss { question, cores: [a, b, c], peak } in &misses {
            println!("{number} {question:?}: {a:.3} {b:.3} {c:.3}, peak {peak:.3?} K");
        }
        misses
    });
    compared.collect()
}

/// Smallest width that contains a share of errors.
fn width(errors: Vec<f64>, within: f64) -> f64 {
    Sorted::new(errors).quantile(within, Quantile::Reached).unwrap()
}

/// With a band that contains nine in ten, fewer than nine of twelve are within it once in forty times by chance alone.
#[test]
fn a_dozen_comparisons_lie_within_the_band_as_often_as_it_states() {
    let bands = Bands::embedded().unwrap();
    let misses = misses(OTHERS);
    assert_eq!((misses.len(), bands.within), (12, 0.9));
    for number in 0..NUMBERS {
        let lies = |miss: &&Miss| {
            let band = bands.of(miss.question).unwrap();
            let stated = band.core_k.get(number).copied().unwrap_or(band.peak_k);
            numbers(miss)[number].is_none_or(|error| error <= stated)
        };
        let count = misses.iter().filter(lies).count();
        assert!(count >= 9, "{count} of 12 at {:?}", SPANS_S.get(number));
    }
}

/// Ten minutes to half an hour: `cargo test --release -p saute-plan --test plan forecast:: -- --ignored --nocapture campaign`.
#[test]
#[ignore = "ten minutes to half an hour: 160 full cooks"]
fn campaign_finds_the_numbers_of_the_band() {
    let bands = Bands::embedded().unwrap();
    let misses = misses(CAMPAIGN);
    assert!(misses.len() >= 100, "{}", misses.len());
    let mut found = Vec::new();
    for question in Question::ALL {
        let own: Vec<_> = misses.iter().filter(|miss| miss.question == question).map(numbers).collect();
        let of = |number: usize| width(own.iter().filter_map(|errors| errors[number]).collect(), bands.within);
        let [a, b, c, peak]: [f64; NUMBERS] = core::array::from_fn(of);
        println!("{question:?} ({}): core_k = [{a:.2}, {b:.2}, {c:.2}], peak_k = {peak:.2}", own.len());
        found.push((question, [a, b, c, peak]));
    }
    for (question, widths) in found {
        let band = bands.of(question).unwrap();
        for (number, width) in widths.into_iter().enumerate() {
            let stated = band.core_k.get(number).copied().unwrap_or(band.peak_k);
            assert!((stated - width).abs() < 0.01, "{question:?}: {stated} stated, {width} found");
        }
    }
}

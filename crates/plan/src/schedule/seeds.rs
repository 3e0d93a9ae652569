//! Where the search starts: drafts with the structure of the shipped recipes.

use std::collections::BTreeSet;

use crate::schedule::{Draft, Order};

/// Temperature of the pan when the food goes in [°C] (chosen: the shipped recipes have 180–220 °C).
const PREHEAT_C: u32 = 200;
/// Guess of the time in the pan for each millimetre of thickness [s/mm] (measured on the shipped steaks: 22–30).
const GUESS_S_MM: f64 = 24.0;
/// Shortest time between flips that the search starts with [s] (chosen: more flips hardly raise the share).
const RHYTHM_S: u32 = 45;
/// Times after which the power changes [s] (chosen: a short and a long sear).
const CHANGES_S: [u32; 2] = [45, 120];
/// Place of a single flip in the guessed time [-] (chosen: the second face starts warmer and needs less).
const ONE_FLIP: f64 = 0.55;
/// Least time between flips [s] (chosen: the turner needs a few seconds; faster turning gains nothing measurable).
pub(crate) const LEAST_EVERY_S: u32 = 20;

/// Returns the drafts to start with, in a fixed order.
pub(crate) fn seeds(order: &Order) -> BTreeSet<Draft> {
    let flips = rhythm(order);
    let draft =
        |(first, change_s, then)| Draft { preheat_c: order.pan_c.unwrap_or(PREHEAT_C), first, change_s, then, ..flips };
    let plain: BTreeSet<Draft> = powers(order.hob_w.len()).into_iter().map(draft).collect();
    if order.plain {
        return plain.into_iter().filter(Draft::has_one_power).collect();
    }
    let both = plain.iter().map(|draft| Draft { sears: 2, ..*draft }).filter(Draft::is_distinct);
    both.chain(plain.iter().copied()).collect()
}

/// Returns the powers to start with: the lowest ones alone, and to the lowest from each other one.
fn powers(count: usize) -> Vec<(usize, u32, usize)> {
    let last = count.saturating_sub(1);
    let mut chosen: Vec<usize> = vec![0, count / 3, count / 2, last];
    chosen.dedup();
    let alone = chosen.iter().filter(|p| **p < last || count == 1);
    let mut powers: Vec<_> = alone.map(|p| (*p, 0, *p)).collect();
    for first in chosen.iter().skip(1) {
        // The largest power, which has heated the pan, makes it too hot before long.
        let changes = if *first == last { &CHANGES_S[..1] } else { &CHANGES_S[..] };
        powers.extend(changes.iter().map(|change_s| (*first, *change_s, 0)));
    }
    powers
}

/// Returns flips to start with, evenly over the guessed time.
fn rhythm(order: &Order) -> Draft {
    let guess_s = GUESS_S_MM * order.thickness_mm();
    let flips = order.most_flips;
    let none = Draft { preheat_c: 0, first: 0, change_s: 0, then: 0, sears: 1, first_flip_s: 0, every_s: 0, flips };
    let even_s = ((guess_s / (flips + 1) as f64) as u32).max(RHYTHM_S);
    match flips {
        0 => none,
        1 => Draft { first_flip_s: (ONE_FLIP * guess_s) as u32, every_s: LEAST_EVERY_S, ..none },
        _ => Draft { first_flip_s: even_s, every_s: even_s, ..none },
    }
}

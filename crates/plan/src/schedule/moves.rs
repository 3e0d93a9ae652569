//! Steps of the search from a draft to its neighbours.

use crate::schedule::seeds::LEAST_EVERY_S;
use crate::schedule::{Draft, Order};

/// Lowest and highest temperature of the pan when the food goes in [°C] (chosen), and how far from one that a food states [K] (chosen).
const PREHEAT_C: [u32; 2] = [140, 230];
const PREHEAT_K: u32 = 20;

/// Longest time until the power changes [s] (chosen).
const LATEST_CHANGE_S: u32 = 900;

/// How often the food may be seared [-] (chosen: twice is once a face; nobody wants to turn a knob more often).
const SEARS: [usize; 3] = [1, 2, 4];
/// Time that is left between the end of a sear and the next flip [s] (chosen: the pan cools a little).
const BETWEEN_S: u32 = 15;

/// Sizes of the steps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Stride {
    preheat_k: u32,
    change_s: u32,
    /// Factor of the rhythm of the flips [-].
    rhythm: f64,
    /// True if powers change too.
    pub(crate) powers: bool,
}

impl Stride {
    /// The strides, from coarse to fine; powers are gone through first.
    pub(crate) const ALL: [Self; 3] = [
        Self { preheat_k: 20, change_s: 40, rhythm: 1.4, powers: true },
        Self { preheat_k: 20, change_s: 40, rhythm: 1.4, powers: false },
        Self { preheat_k: 10, change_s: 20, rhythm: 1.2, powers: false },
    ];
}

/// Returns the neighbours of a draft, in a fixed order; some may be equal to it or to each other. Where its power had to change earlier,
/// since the pan became too hot, that time is given [s].
pub(crate) fn neighbours(draft: &Draft, changed_s: Option<u32>, order: &Order, stride: Stride) -> Vec<Draft> {
    let mut all = if order.plain {
        other_power(draft, order.hob_w.len())
    } else {
        powers(draft, changed_s, order.hob_w.len(), stride)
    };
    // Where it makes no difference there is only one draft.
    all.retain(Draft::is_distinct);
    let [low, high] = order.pan_c.map_or(PREHEAT_C, |c| [c.saturating_sub(PREHEAT_K), c + PREHEAT_K]);
    all.push(Draft { preheat_c: (draft.preheat_c + stride.preheat_k).min(high), ..*draft });
    all.push(Draft { preheat_c: draft.preheat_c.saturating_sub(stride.preheat_k).max(low), ..*draft });
    all.extend(rhythms(draft, order, stride));
    all
}

/// Returns the draft with everything that is different in drafts that were found to be better than it.
pub(crate) fn combined(from: &Draft, better: &[Draft]) -> Draft {
    let mut all = *from;
    for draft in better {
        all.preheat_c = if draft.preheat_c == from.preheat_c { all.preheat_c } else { draft.preheat_c };
        if (draft.first, draft.change_s, draft.then) != (from.first, from.change_s, from.then) {
            (all.first, all.change_s, all.then) = (draft.first, draft.change_s, draft.then);
            all.sears = draft.sears;
        }
        if (draft.first_flip_s, draft.every_s) != (from.first_flip_s, from.every_s) {
            (all.first_flip_s, all.every_s) = (draft.first_flip_s, draft.every_s);
        }
    }
    all
}

/// The same with the next power up and down, which lasts from putting in to pulling.
fn other_power(draft: &Draft, count: usize) -> Vec<Draft> {
    let beside = [draft.then.checked_sub(1), Some(draft.then + 1).filter(|power| *power < count)];
    beside.into_iter().flatten().map(|power| Draft { first: power, then: power, ..*draft }).collect()
}

fn powers(draft: &Draft, changed_s: Option<u32>, count: usize, stride: Stride) -> Vec<Draft> {
    let last = count.saturating_sub(1);
    let changed = |first: usize, change_s: u32, then: usize| {
        // Without a change there is only one power.
        let change_s = if first == then { 0 } else { change_s.min(LATEST_CHANGE_S) };
        let first = if change_s == 0 { then } else { first };
        Draft { first, change_s, then, ..*draft }
    };
    let Draft { first, change_s, then, .. } = *draft;
    let mut all = vec![changed(first, changed_s.unwrap_or(change_s).saturating_sub(stride.change_s), then)];
    if changed_s.is_none() {
        all.push(changed(first, change_s + stride.change_s, then));
    }
    if stride.powers {
        let sear_s = change_s.max(stride.change_s);
        all.extend(SEARS.into_iter().filter(|sears| *sears != draft.sears).map(|sears| seared(draft, sears)));
        all.push(changed((first + 1).min(last), sear_s, then));
        all.push(changed(first.saturating_sub(1), sear_s, then));
        all.push(changed(first, sear_s, (then + 1).min(last)));
        all.push(changed(first, sear_s, then.saturating_sub(1)));
    }
    all
}

/// Returns the draft with so many sears, none of which lasts until the next flip.
fn seared(draft: &Draft, sears: usize) -> Draft {
    let draft = Draft { sears, ..*draft };
    let longest_s = if sears > 1 { draft.shortest_s().saturating_sub(BETWEEN_S) } else { LATEST_CHANGE_S };
    Draft { change_s: draft.change_s.min(longest_s), ..draft }
}

fn rhythms(draft: &Draft, order: &Order, stride: Stride) -> Vec<Draft> {
    let scaled = |s: u32, factor: f64| (libm::round(f64::from(s) * factor) as u32).max(LEAST_EVERY_S);
    let [wider, closer] = [stride.rhythm, 1.0 / stride.rhythm];
    let every = |factor: f64| Draft {
        first_flip_s: scaled(draft.first_flip_s, factor),
        every_s: scaled(draft.every_s, factor),
        ..*draft
    };
    let first = |factor: f64| Draft { first_flip_s: scaled(draft.first_flip_s, factor), ..*draft };
    match order.most_flips {
        0 => Vec::new(),
        1 => vec![first(wider), first(closer)],
        _ => vec![every(wider), every(closer), first(wider)],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const FROM: Draft =
        Draft { preheat_c: 200, first: 1, change_s: 60, then: 0, sears: 1, first_flip_s: 50, every_s: 40, flips: 8 };

    #[test]
    fn what_was_better_alone_is_joined_and_the_best_wins_where_two_change_the_same() {
        let hotter = Draft { preheat_c: 220, ..FROM };
        let [shorter, longer] = [40, 80].map(|change_s| Draft { change_s, ..FROM });
        let rarer = Draft { every_s: 56, first_flip_s: 70, ..FROM };
        let joined = combined(&FROM, &[shorter, hotter, rarer, longer]);
        assert_eq!(joined, Draft { preheat_c: 220, change_s: 80, every_s: 56, first_flip_s: 70, ..FROM });
    }

    #[test]
    fn a_sear_that_the_pan_ended_is_not_made_longer() {
        let sears = |changed_s| -> Vec<u32> {
            powers(&FROM, changed_s, 2, Stride::ALL[1]).iter().map(|draft| draft.change_s).collect()
        };
        assert_eq!((sears(None), sears(Some(50))), (vec![20, 100], vec![10]));
    }

    #[test]
    fn a_plain_plan_keeps_one_power_whatever_changes() {
        let alone = Draft { first: 1, then: 1, change_s: 0, ..FROM };
        let beside = other_power(&alone, 3);
        assert_eq!(beside.iter().map(|draft| draft.then).collect::<Vec<_>>(), [0, 2]);
        assert!(beside.iter().all(Draft::has_one_power) && !FROM.has_one_power());
        assert_eq!(other_power(&Draft { first: 0, then: 0, change_s: 0, ..FROM }, 1), []);
    }

    #[test]
    fn powers_stay_on_the_list_and_a_single_power_has_no_change() {
        for draft in powers(&FROM, None, 2, Stride::ALL[0]) {
            assert!(draft.first < 2 && draft.then < 2, "{draft:?}");
            assert_eq!(draft.change_s == 0, draft.first == draft.then, "{draft:?}");
        }
    }
}

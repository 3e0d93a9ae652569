//! How the answers of a class spread, and where the truths were.

use serde::Serialize;

/// Width of a bar of temperatures and shares [°C, %] (chosen: ten bars over what can be answered).
const WIDTH: f64 = 10.0;
/// Classes of doneness at most: whole numbers below are counted one by one (chosen: no scale has so many).
const CLASSES: f64 = 10.0;
/// Bars beyond the first at most [-]: answers are within 0 to 100; a file with others gets no more.
const MOST_MORE: f64 = 10.0;

/// Answers and truths from one value up to another one, in the unit of the question.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Bar {
    /// Lowest value.
    pub from: f64,
    /// The value at which the next bar begins.
    pub to: f64,
    /// Answers in it.
    pub answers: usize,
    /// Truths in it: each student's own cook has its own.
    pub truths: usize,
}

/// True of a number that may be the place of a class of doneness.
pub(super) fn may_be_class(value: f64) -> bool {
    value.fract() == 0.0 && (0.0..CLASSES).contains(&value)
}

/// The bars from the lowest to the highest answer or truth, those between included.
pub(super) fn bars(answers: &[f64], truths: &[f64]) -> Vec<Bar> {
    let all = || answers.iter().chain(truths).copied();
    let are_classes = all().all(may_be_class);
    let width = if are_classes { 1.0 } else { WIDTH };
    let place = |value: f64| (value / width).floor();
    let (low, high) = all().map(place).fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), p| (l.min(p), h.max(p)));
    if low > high {
        return Vec::new();
    }
    (0..=(high - low).min(MOST_MORE) as usize)
        .map(|step| {
            let at = low + step as f64;
            let count = |values: &[f64]| values.iter().filter(|value| place(**value) == at).count();
            Bar { from: at * width, to: (at + 1.0) * width, answers: count(answers), truths: count(truths) }
        })
        .collect()
}

//! How long a value takes to its goal at the pace of the last time.

use std::collections::{BTreeMap, VecDeque};

/// Fall of a value from which its pace begins again, as a share of it [-] (chosen: another face is below, cold food is in the pan).
const FALLS: f64 = 0.2;
/// Simulated time between two samples [s].
const EVERY_S: f64 = 1.0;
/// How much faster or slower than a clock a time that was told may run [-] (chosen: few notice that a minute lasts 30 s or that it waits,
/// and everybody that it jumps).
const RUNS_OFF: f64 = 1.0;
/// From this factor with a minute besides, what was told is given up (chosen: the hob was turned, or something cold came in).
const OTHER: f64 = 2.0;
/// The longest time that is shown [s] (chosen: beyond half an hour the pace means nothing).
const LONGEST_S: f64 = 1800.0;

/// What goes towards a goal.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Course {
    /// The pan gets hot enough for the food.
    Pan,
    /// The core that would be reached if the food were taken out now.
    Core,
    /// The side below gets brown.
    Brown,
}

impl Course {
    /// How far the pace looks back, and the least that it needs [simulated s] (chosen: of the core as long as a side lies, since each flip
    /// makes it faster for a while, and a cook was told 5:10 and then 2:20).
    fn back_s(self) -> [f64; 2] {
        match self {
            Self::Pan => [30.0, 5.0],
            Self::Core => [150.0, 30.0],
            Self::Brown => [40.0, 10.0],
        }
    }
}

/// Samples of each value, the last at the end.
#[derive(Clone, Debug, Default)]
pub struct TimeLeft {
    samples: BTreeMap<Course, VecDeque<(f64, f64)>>,
    /// What was told last for a course and a goal, with when [s].
    told: BTreeMap<(Course, u64), (f64, f64)>,
}

impl TimeLeft {
    /// Notes a value at a time [s]; returns how long it takes to `goal` [s], or none while its pace is not known or leads away.
    pub fn until(&mut self, course: Course, now_s: f64, value: f64, goal: f64) -> Option<f64> {
        let [back_s, least_s] = course.back_s();
        let samples = self.samples.entry(course).or_default();
        note(samples, back_s, now_s, value);
        let (from_s, from) = *samples.front()?;
        let (lasted_s, gained) = (now_s - from_s, value - from);
        let is_known = lasted_s >= least_s && gained > 0.0;
        let left_s =
            is_known.then(|| (goal - value).max(0.0) * lasted_s / gained).filter(|left_s| *left_s <= LONGEST_S);
        let told = (course, goal.to_bits());
        let Some(left_s) = left_s else {
            self.told.remove(&told);
            return None;
        };
        self.told.retain(|_, (told_s, _)| (0.0..=back_s).contains(&(now_s - *told_s)));
        let left_s = self.told.get(&told).map_or(left_s, |(told_s, told)| follows(now_s - told_s, *told, left_s));
        self.told.insert(told, (now_s, left_s));
        Some(left_s)
    }
}

/// What is told some time [s] after a time left was told [s], now that another one is found [s].
fn follows(since_s: f64, told_s: f64, found_s: f64) -> f64 {
    let by_clock = told_s - since_s;
    if found_s > OTHER * by_clock + 60.0 || by_clock > OTHER * found_s + 60.0 {
        return found_s;
    }
    let off_s = RUNS_OFF * since_s;
    by_clock + (found_s - by_clock).clamp(-off_s, off_s)
}

fn note(samples: &mut VecDeque<(f64, f64)>, back_s: f64, now_s: f64, value: f64) {
    // Time that was turned back, another cook, or another face.
    let is_other =
        |(last_s, last): &(f64, f64)| now_s < *last_s || now_s > last_s + back_s || value < last - FALLS * last.abs();
    if samples.back().is_some_and(is_other) {
        samples.clear();
    }
    if samples.back().is_none_or(|(last_s, _)| now_s >= last_s + EVERY_S) {
        samples.push_back((now_s, value));
    }
    while samples.front().is_some_and(|(first_s, _)| *first_s < now_s - back_s) {
        samples.pop_front();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_time_that_was_told_never_jumps_and_meets_what_is_found() {
        let mut left = TimeLeft::default();
        let (mut before, mut core) = (None, 10.0);
        for s in 0..400 {
            // A flip at 200 s makes it half as fast again.
            core += if s < 200 { 0.1 } else { 0.15 };
            let told = left.until(Course::Core, f64::from(s), core, 80.0);
            if let (Some(before), Some(told)) = (before, told) {
                let ran: f64 = before - told;
                assert!((-1e-9..=2.0 + 1e-9).contains(&ran), "{s} s: {before} then {told}");
            }
            before = told;
        }
        let (told, true_s) = (before.expect("a pace"), (80.0 - core) / 0.15);
        assert!((told - true_s).abs() < 1.0, "{told} {true_s}");
    }

    #[test]
    fn a_steady_value_arrives_when_it_is_told_and_nothing_is_told_of_one_that_falls() {
        let mut left = TimeLeft::default();
        let at = |left: &mut TimeLeft, s: f64, value: f64| left.until(Course::Core, s, value, 60.0);
        assert_eq!(at(&mut left, 0.0, 10.0), None);
        assert_eq!(at(&mut left, 20.0, 12.0), None, "too soon");
        for s in 30..200 {
            let told = at(&mut left, f64::from(s), 10.0 + 0.1 * f64::from(s)).expect("a pace");
            assert!((told - (500.0 - f64::from(s))).abs() < 1e-6, "{s} {told}");
        }
        for s in 200..400 {
            at(&mut left, f64::from(s), 30.0 - 0.01 * f64::from(s - 200));
        }
        assert_eq!(at(&mut left, 400.0, 28.0), None);
        // Time was turned back: the pace begins again.
        assert_eq!(at(&mut left, 100.0, 20.0), None);
        assert_eq!(at(&mut left, 110.0, 10.0), None, "it fell");
        assert_eq!(left.samples[&Course::Core].len(), 1);
        assert_eq!(left.until(Course::Pan, 106.0, 100.0, 160.0), None, "something else begins anew too");
    }
}

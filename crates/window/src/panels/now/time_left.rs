//! How long a value takes to its goal at the pace of the last half minute.

use std::collections::VecDeque;

/// How far the pace looks back, and the least that it needs [simulated s] (chosen: longer than a flip disturbs, shorter than a
/// change of power needs to show).
const BACK_S: f64 = 30.0;
const LEAST_S: f64 = 5.0;
/// Simulated time between two samples [s].
const EVERY_S: f64 = 1.0;
/// The longest time that is told [s] (chosen: beyond half an hour the pace says nothing).
const LONGEST_S: f64 = 1800.0;

/// What goes towards a goal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Course {
    /// The pan gets hot enough for the food.
    Pan,
    /// The core that would be reached if the food were taken out now.
    Core,
}

/// Samples of a value, the last at the end.
#[derive(Clone, Debug, Default)]
pub struct TimeLeft {
    course: Option<Course>,
    samples: VecDeque<(f64, f64)>,
}

impl TimeLeft {
    /// Notes a value at a time [s]; returns how long it takes to `goal` [s], or none while its pace is not known or leads away.
    pub fn until(&mut self, course: Course, now_s: f64, value: f64, goal: f64) -> Option<f64> {
        self.note(course, now_s, value);
        let (from_s, from) = *self.samples.front()?;
        let (lasted_s, gained) = (now_s - from_s, value - from);
        if lasted_s < LEAST_S || gained <= 0.0 {
            return None;
        }
        let left_s = (goal - value).max(0.0) * lasted_s / gained;
        (left_s <= LONGEST_S).then_some(left_s)
    }

    fn note(&mut self, course: Course, now_s: f64, value: f64) {
        // Time that was turned back, or another cook.
        let jumps = self.samples.back().is_some_and(|(last_s, _)| now_s < *last_s || now_s > last_s + BACK_S);
        if self.course != Some(course) || jumps {
            (self.course, self.samples) = (Some(course), VecDeque::new());
        }
        if self.samples.back().is_none_or(|(last_s, _)| now_s >= last_s + EVERY_S) {
            self.samples.push_back((now_s, value));
        }
        while self.samples.front().is_some_and(|(first_s, _)| *first_s < now_s - BACK_S) {
            self.samples.pop_front();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_steady_value_arrives_when_it_is_told_and_nothing_is_told_of_one_that_falls() {
        let mut left = TimeLeft::default();
        let at = |left: &mut TimeLeft, s: f64, value: f64| left.until(Course::Core, s, value, 60.0);
        assert_eq!(at(&mut left, 0.0, 10.0), None);
        assert_eq!(at(&mut left, 4.0, 10.4), None, "too soon");
        for s in 5..200 {
            let told = at(&mut left, f64::from(s), 10.0 + 0.1 * f64::from(s)).expect("a pace");
            assert!((told - (500.0 - f64::from(s))).abs() < 1e-6, "{s} {told}");
        }
        for s in 200..240 {
            at(&mut left, f64::from(s), 30.0 - 0.1 * f64::from(s - 200));
        }
        assert_eq!(at(&mut left, 240.0, 26.0), None);
        // Time was turned back: the pace begins anew.
        assert_eq!(at(&mut left, 100.0, 20.0), None);
        assert_eq!(left.until(Course::Pan, 106.0, 100.0, 160.0), None, "something else begins anew too");
    }
}

//! A candidate on a grid: what the search varies.

use crate::schedule::{Order, Schedule, Setting};

/// A candidate on a grid. The time at which the food is pulled is not part of it: a job finds that.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Draft {
    /// Temperature of the pan at which the food goes in [°C].
    pub preheat_c: u32,
    /// Index of the power from then on.
    pub first: usize,
    /// Time after which the power changes [s]; 0 for no change.
    pub change_s: u32,
    /// Index of the power after the change.
    pub then: usize,
    /// True if the second face gets the first power for the same time, after the first flip.
    pub both: bool,
    /// Time from putting in to the first flip [s].
    pub first_flip_s: u32,
    /// Time between flips [s].
    pub every_s: u32,
    /// Number of flips [-].
    pub flips: usize,
}

impl Draft {
    /// Returns true if the power rises again for the second face: a longer first power lasts until then anyway.
    pub(crate) fn sears_both(&self) -> bool {
        let changes = self.change_s > 0 && self.first != self.then;
        self.both && changes && self.flips > 0 && self.change_s < self.first_flip_s
    }

    /// Returns the schedule, given the time at which the pan has the temperature of the draft [s] and the latest time to pull [s
    /// after putting in].
    pub fn schedule(&self, order: &Order, put_s: u32, limit_s: u32) -> Schedule {
        let power = |index: usize| order.hob_w.get(index).copied().unwrap_or_default();
        let most = order.hob_w.last().copied().unwrap_or_default();
        let mut powers = vec![Setting { at_s: 0, hob_w: most }];
        let mut set = |at_s: u32, hob_w: f64| {
            if powers.last().is_some_and(|last| last.hob_w != hob_w) {
                powers.push(Setting { at_s, hob_w });
            }
        };
        if self.change_s > 0 {
            set(put_s, power(self.first));
        }
        set(put_s + self.change_s, power(self.then));
        if self.sears_both() {
            set(put_s + self.first_flip_s, power(self.first));
            set(put_s + self.first_flip_s + self.change_s, power(self.then));
        }
        let flip = |k: usize| put_s + self.first_flip_s + k as u32 * self.every_s;
        let flips_s = (0..self.flips).map(flip).collect();
        let pull_s = put_s + limit_s;
        Schedule { powers, put_s, flips_s, pull_s, rest_s: 0 }.pulled_at(pull_s, 60)
    }
}

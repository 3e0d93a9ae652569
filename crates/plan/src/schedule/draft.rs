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
    /// How often the first power is given for that time: when the food goes in, and after the next flips [-].
    pub sears: usize,
    /// Time from putting in to the first flip [s].
    pub first_flip_s: u32,
    /// Time between flips [s].
    pub every_s: u32,
    /// Number of flips [-].
    pub flips: usize,
}

impl Draft {
    /// True if one power lasts from putting in to pulling.
    pub(crate) fn has_one_power(&self) -> bool {
        self.change_s == 0 && self.sears == 1
    }

    /// Returns true if the power rises again after each flip that it is to rise after: a longer first power lasts until then anyway.
    pub(crate) fn is_distinct(&self) -> bool {
        let changes = self.change_s > 0 && self.first != self.then;
        self.sears <= 1 || (changes && self.flips + 1 >= self.sears && self.change_s < self.shortest_s())
    }

    /// Shortest time for which a face that is seared is in the pan, but the last one [s].
    pub(crate) fn shortest_s(&self) -> u32 {
        if self.sears > 2 { self.first_flip_s.min(self.every_s) } else { self.first_flip_s }
    }

    /// Returns the time for which a cook of the draft had its first power [s], where the pan became too hot for all of it.
    pub(crate) fn changed_s(&self, cooked: &Schedule, order: &Order) -> Option<u32> {
        let (first, then) = (order.hob_w.get(self.first)?, order.hob_w.get(self.then)?);
        let pairs = cooked.powers.windows(2).filter(|pair| pair[0].hob_w == *first && pair[1].hob_w == *then);
        let longest = pairs.map(|pair| pair[1].at_s - pair[0].at_s.max(cooked.put_s).min(pair[1].at_s)).max()?;
        (self.change_s > 0 && longest < self.change_s).then_some(longest)
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
        let flip = |k: usize| put_s + self.first_flip_s + k as u32 * self.every_s;
        if self.is_distinct() {
            for turned_s in (0..self.sears.saturating_sub(1)).map(flip) {
                set(turned_s, power(self.first));
                set(turned_s + self.change_s, power(self.then));
            }
        }
        let flips_s = (0..self.flips).map(flip).collect();
        let pull_s = put_s + limit_s;
        Schedule { powers, put_s, flips_s, pull_s, rest_s: 0 }.pulled_at(pull_s, 60)
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use saute_kitchen::Library;

    use super::*;
    use crate::goal::Goal;

    fn order() -> Order {
        let library = Library::embedded().unwrap();
        Order {
            food: "beef-lean".into(),
            size_mm: vec![120.0, 80.0, 25.0],
            initial_c: 5.0,
            count: None,
            hob: None,
            pan: "carbon-steel-26".into(),
            hob_w: vec![400.0, 1100.0, 2000.0],
            most_flips: 1,
            most_rest_s: None,
            pan_c: None,
            plain: false,
            goal: Goal::new(&"medium".parse().unwrap(), library.scale("chefs").unwrap(), 60.0).unwrap(),
        }
    }

    const DRAFT: Draft =
        Draft { preheat_c: 200, first: 1, change_s: 40, then: 0, sears: 2, first_flip_s: 300, every_s: 30, flips: 1 };

    fn powers(draft: Draft) -> Vec<(u32, f64)> {
        draft.schedule(&order(), 60, 900).powers.iter().map(|p| (p.at_s, p.hob_w)).collect()
    }

    #[test]
    fn a_draft_preheats_sears_each_face_and_goes_on_gently() {
        let sear = [(0, 2000.0), (60, 1100.0), (100, 400.0), (360, 1100.0), (400, 400.0)];
        assert_eq!(powers(DRAFT), sear);
        assert_eq!(powers(Draft { sears: 1, ..DRAFT }), sear[..3]);
        let third = Draft { sears: 3, first_flip_s: 60, every_s: 50, flips: 2, ..DRAFT };
        assert_eq!(powers(third)[3..], [(120, 1100.0), (160, 400.0), (170, 1100.0), (210, 400.0)]);
        // Without a change, and when the first power lasts beyond the flip, the second face needs no other power.
        assert_eq!(powers(Draft { change_s: 0, ..DRAFT }), [(0, 2000.0), (60, 400.0)]);
        assert_eq!(powers(Draft { change_s: 320, ..DRAFT }), [(0, 2000.0), (60, 1100.0), (380, 400.0)]);
    }

    #[test]
    fn its_recipe_has_the_steps_in_order_and_nothing_after_the_pull() {
        let schedule = DRAFT.schedule(&order(), 60, 900).pulled_at(380, 120);
        let text = schedule.recipe_text(&order());
        let steps: Vec<&str> = text.split("[[step]]\n").skip(1).map(str::trim_end).collect();
        let expected = [
            "at_s = 0\nhob_w = 2000",
            "at_s = 60\nput = \"beef-lean\"",
            "at_s = 60\nhob_w = 1100",
            "at_s = 100\nhob_w = 400",
            "at_s = 360\nhob_w = 1100",
            "at_s = 360\nflip = \"beef-lean\"",
            "at_s = 380\nrest = \"beef-lean\"",
            "at_s = 380\nhob_w = 0",
            "at_s = 500\nend = true",
        ];
        assert_eq!(steps, expected);
        assert!(schedule.recipe(&order(), &Library::embedded().unwrap()).is_ok());
    }
}

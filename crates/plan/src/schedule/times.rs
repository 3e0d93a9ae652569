//! A schedule in whole seconds, and the recipe that it is.

use std::fmt::Write;

use saute_kitchen::Library;
use saute_recipe::Recipe;
use saute_schema::InputError;
use serde::{Deserialize, Serialize};

use crate::schedule::Order;

/// A power of the hob from a time on.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Serialize)]
pub struct Setting {
    /// Time since the start [s].
    pub at_s: u32,
    /// Electrical power [W].
    pub hob_w: f64,
}

/// The times of a cook, in seconds since the hob is switched on.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct Schedule {
    /// Powers of the hob, in order; the first one preheats the pan.
    pub powers: Vec<Setting>,
    /// When the food goes into the pan [s].
    pub put_s: u32,
    /// When it is turned over [s].
    pub flips_s: Vec<u32>,
    /// When it comes out of the pan; the hob is then switched off [s].
    pub pull_s: u32,
    /// How long it rests on the board [s].
    pub rest_s: u32,
}

/// One step: time [s] and the line of its action.
type Line = (u32, String);

impl Schedule {
    /// Returns the schedule with all powers multiplied by a factor, up to the largest of the hob [W].
    pub(crate) fn with_power(&self, factor: f64, largest_w: f64) -> Self {
        let mut changed = self.clone();
        changed.powers.iter_mut().for_each(|p| p.hob_w = (factor * p.hob_w).min(largest_w));
        changed
    }

    /// Returns the schedule without what would come at its end or later.
    pub(crate) fn pulled_at(&self, pull_s: u32, rest_s: u32) -> Self {
        let mut pulled = Self { pull_s, rest_s, ..self.clone() };
        pulled.flips_s.retain(|s| *s < pull_s);
        pulled.powers.retain(|p| p.at_s < pull_s);
        pulled
    }

    /// Turns the hob down now [s] to the next power, if that is a lower one.
    pub(crate) fn turn_down(&mut self, now_s: u32) {
        let Some(next) = self.powers.iter().position(|p| p.at_s > now_s).filter(|next| *next > 0) else { return };
        if self.powers[next].hob_w < self.powers[next - 1].hob_w {
            self.powers[next].at_s = now_s;
            // A power that would be set at the same time is not set at all.
            if self.powers[next - 1].at_s == now_s {
                self.powers.remove(next - 1);
            }
        }
    }

    /// Returns the text of the recipe that is cooked by this schedule.
    pub fn recipe_text(&self, order: &Order) -> String {
        let end_s = self.pull_s + self.rest_s;
        let mut text = String::new();
        order.write_head(&mut text, (end_s + 1).max(3600));
        let mut lines = self.lines(order);
        lines.push((self.pull_s, format!("rest = {:?}", order.food)));
        lines.push((self.pull_s, "hob_w = 0".to_owned()));
        lines.push((end_s, "end = true".to_owned()));
        for (at_s, action) in lines {
            // Writing to a string cannot fail.
            let _ = write!(text, "[[step]]\nat_s = {at_s}\n{action}\n");
        }
        text
    }

    /// Returns the steps before the food is pulled, in order.
    fn lines(&self, order: &Order) -> Vec<Line> {
        let mut lines: Vec<Line> = vec![(self.put_s, format!("put = {:?}", order.food))];
        lines.extend(self.powers.iter().map(|p| (p.at_s, format!("hob_w = {}", p.hob_w))));
        lines.extend(self.flips_s.iter().map(|s| (*s, format!("flip = {:?}", order.food))));
        // The sort is stable: at the same time the food goes in before the power changes, and that before a flip.
        lines.sort_by_key(|(at_s, _)| *at_s);
        lines
    }

    /// Returns the recipe.
    ///
    /// # Errors
    ///
    /// If the order or a power is not what a recipe may state.
    pub fn recipe(&self, order: &Order, library: &Library) -> Result<Recipe, InputError> {
        Recipe::parse(&self.recipe_text(order), "plan", library)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn turned_down(now_s: u32) -> Vec<(u32, f64)> {
        let powers = [(0, 2000.0), (60, 1100.0), (100, 400.0), (200, 1100.0)];
        let powers = powers.map(|(at_s, hob_w)| Setting { at_s, hob_w }).to_vec();
        let mut schedule = Schedule { powers, put_s: 60, flips_s: vec![200], pull_s: 300, rest_s: 60 };
        schedule.turn_down(now_s);
        schedule.powers.iter().map(|power| (power.at_s, power.hob_w)).collect()
    }

    #[test]
    fn a_hot_pan_brings_the_next_lower_power_forward_and_no_higher_one() {
        assert_eq!(turned_down(80), [(0, 2000.0), (60, 1100.0), (80, 400.0), (200, 1100.0)]);
        assert_eq!(turned_down(60), [(0, 2000.0), (60, 400.0), (200, 1100.0)], "what would be set now is not set");
        assert_eq!(turned_down(150), [(0, 2000.0), (60, 1100.0), (100, 400.0), (200, 1100.0)]);
    }
}

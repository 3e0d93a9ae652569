//! Checks the table of `repeat`.

use crate::action::{Action, ActionKind, Repeat, RepeatEnd};
use crate::check::recipe_check::{Check, Checked, FoodNames};
use crate::file::repeat_file::RepeatEntry;
use crate::file::step_file::StepKeys;

/// A valid repeat, for remedies.
const EXAMPLE: &str = "repeat = { flip = \"steak\", every_s = 30, until = { food = \"steak\", core_c = 52 } }";

impl Check<'_> {
    /// Returns the repeated action with its rhythm and its end.
    pub(crate) fn repeat(&self, entry: &RepeatEntry, names: &FoodNames) -> Checked<Action> {
        let action = Box::new(self.repeated(entry, names)?);
        let Some(every_s) = &entry.keys.every_s else {
            return self.input.error(entry.at, "repeat has no every_s", format!("write how often, as in {EXAMPLE}"));
        };
        Ok(Action::Repeat(Repeat { action, every_s: *every_s.get_ref(), end: self.repeat_end(entry, names)? }))
    }

    fn repeated(&self, entry: &RepeatEntry, names: &FoodNames) -> Checked<Action> {
        match entry.actions.as_slice() {
            [one] => self.one_action(one, &StepKeys::default(), names),
            [] => {
                let repeatable = ActionKind::ALL.into_iter().filter(|kind| kind.is_repeatable());
                let names: Vec<&str> = repeatable.map(ActionKind::name).collect();
                self.input.error(entry.at, "repeat has no action", format!("add one of {}", names.join(", ")))
            }
            _ => self.input.error(entry.at, "repeat has more than one action", format!("keep one, as in {EXAMPLE}")),
        }
    }

    fn repeat_end(&self, entry: &RepeatEntry, names: &FoodNames) -> Checked<RepeatEnd> {
        match (&entry.keys.times, &entry.keys.until) {
            (Some(times), None) => Ok(RepeatEnd::Times(*times.get_ref())),
            (None, Some(until)) => Ok(RepeatEnd::Until(self.condition("until", until, names)?)),
            (Some(_), Some(_)) => self.input.error(entry.at, "repeat has both until and times", "keep one of them"),
            (None, None) => {
                let remedy = format!("add times = 8, or until as in {EXAMPLE}");
                self.input.error(entry.at, "repeat has neither until nor times", remedy)
            }
        }
    }
}

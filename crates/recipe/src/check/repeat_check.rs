//! Checks the table of `repeat`.

use crate::action::{Action, ActionKind, Repeat, RepeatEnd};
use crate::check::recipe_check::{Check, Checked, FoodNames};
use crate::file::repeat_file::{EVERY_S, RepeatEntry, TIMES};
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
        let every_s = self.input.ranged("repeat.every_s", every_s, EVERY_S[0], EVERY_S[1])?;
        Ok(Action::Repeat(Repeat { action, every_s, end: self.repeat_end(entry, names)? }))
    }

    fn repeated(&self, entry: &RepeatEntry, names: &FoodNames) -> Checked<Action> {
        match entry.actions.as_slice() {
            [one] if one.kind().is_repeatable() => self.one_action(one, &StepKeys::default(), names),
            [one] => {
                let message = format!("repeat cannot carry out {}", one.kind());
                self.input.error(entry.at, message, "repeat another action; end the cook in a [[step]] of its own")
            }
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
            (Some(times), None) => match u32::try_from(*times.get_ref()) {
                Ok(number) if (TIMES[0]..=TIMES[1]).contains(times.get_ref()) => Ok(RepeatEnd::Times(number)),
                _ => {
                    let message = format!("repeat.times = {} is out of range", times.get_ref());
                    self.input.error(times.span().start, message, format!("it may be {} to {}", TIMES[0], TIMES[1]))
                }
            },
            (None, Some(until)) => Ok(RepeatEnd::Until(self.condition("until", until, names)?)),
            (Some(_), Some(_)) => self.input.error(entry.at, "repeat has both until and times", "keep one of them"),
            (None, None) => {
                let remedy = format!("add times = 8, or until as in {EXAMPLE}");
                self.input.error(entry.at, "repeat has neither until nor times", remedy)
            }
        }
    }
}

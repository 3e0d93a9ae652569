//! What can be known of a recipe's steps before the cook: foods are where a step needs them, times go forward, there is an end.

use std::collections::BTreeMap;

use crate::command::Command;
use crate::input_error::{InputError, InputText};
use crate::recipe::{Action, Deed, Step, Target, Trigger};

/// What holds as the steps go by.
pub(crate) struct Sequence<'a> {
    input: InputText<'a>,
    in_pan: BTreeMap<&'a str, bool>,
    earliest: f64,
}

impl<'a> Sequence<'a> {
    /// Before the first step.
    pub(crate) fn new(input: InputText<'a>, foods: impl Iterator<Item = &'a str>) -> Self {
        Self { input, in_pan: foods.map(|id| (id, false)).collect(), earliest: 0.0 }
    }

    /// Checks all steps, each with its place in the text.
    pub(crate) fn check(mut self, steps: &'a [Step], places: &[usize]) -> Result<(), InputError> {
        let ends = |s: &Step| s.action == Action::End;
        for (step, at) in steps.iter().zip(places) {
            self.check_time(*at, step)?;
            self.check_place(*at, &step.action)?;
        }
        if let Some(i) = steps.iter().position(ends).filter(|i| i + 1 < steps.len()) {
            return self.input.error(
                places[i + 1],
                "there is a step after the end",
                "move end = true to the last step",
            );
        }
        if steps.last().is_none_or(|s| !ends(s)) {
            let end = self.input.text.trim_end().len();
            return self.input.error(end, "the recipe has no end", "close it with a [[step]] that says end = true");
        }
        Ok(())
    }

    fn check_time(&mut self, at: usize, step: &Step) -> Result<(), InputError> {
        let earliest = self.earliest;
        let start = match step.trigger {
            Trigger::At(s) if s < earliest - 1e-9 => {
                let message =
                    format!("at_s = {s} is already past: the steps before it end at {earliest} s at the earliest");
                return self.input.error(at, message, "use a later at_s, or after_s");
            }
            Trigger::At(s) => s,
            Trigger::After(s) => earliest + s,
            _ => earliest,
        };
        self.earliest = start + step.action.duration_s();
        Ok(())
    }

    fn check_place(&mut self, at: usize, action: &'a Action) -> Result<(), InputError> {
        match action {
            Action::Each(target, deed) => self.check_target(at, target, *deed),
            Action::Do(Command::Toss { .. }) if !self.in_pan.values().any(|in_pan| *in_pan) => self.input.error(
                at,
                "there is nothing in the pan to toss at this step",
                "put a food into the pan before it",
            ),
            _ => Ok(()),
        }
    }

    /// A single food must be where the action needs it; of a group, one at least.
    fn check_target(&mut self, at: usize, target: &'a Target, deed: Deed) -> Result<(), InputError> {
        let name = &target.name;
        let fits = |id: &&String| self.in_pan.get(id.as_str()) == Some(&deed.needs_pan());
        if !target.foods.iter().any(|id| fits(&id)) {
            let (place, remedy) = if deed.needs_pan() {
                ("is not in the pan", "put it into the pan before this step")
            } else {
                ("is in the pan already", "a food in the pan cannot be put in again: rest it first")
            };
            return self.input.error(at, format!("\"{name}\" {place} at this step"), remedy);
        }
        if matches!(deed, Deed::Put { .. } | Deed::Rest(_)) {
            let then = matches!(deed, Deed::Put { .. });
            self.in_pan.extend(target.foods.iter().map(|id| (id.as_str(), then)));
        }
        Ok(())
    }
}

//! What can be known of a recipe's steps before the cook: foods are where a step needs them, times go forward, there is an end.

use std::collections::BTreeMap;

use crate::recipe::{Action, Deed, Step, Target, Trigger};
use saute_kitchen::hands::command::{Command, RestOn};
use saute_kitchen::{InputError, InputText};

/// Where a food is as the steps go by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum At {
    Waiting,
    Pan,
    Resting(RestOn),
}

/// How a food lies as the steps go by.
#[derive(Clone, Copy, Debug)]
struct Lies {
    at: At,
    halved: bool,
}

impl Lies {
    /// Whether a deed can be done to it.
    fn fits(self, deed: Deed) -> bool {
        match deed {
            Deed::Put { .. } => self.at != At::Pan,
            Deed::Halve { .. } => matches!(self.at, At::Resting(RestOn::Board | RestOn::Foil)) && !self.halved,
            Deed::Flip | Deed::Rest(_) | Deed::Press { .. } | Deed::Move(_) => self.at == At::Pan,
        }
    }

    /// How it lies after a deed.
    fn after(self, deed: Deed) -> Self {
        match deed {
            Deed::Put { .. } => Self { at: At::Pan, ..self },
            Deed::Rest(on) => Self { at: At::Resting(on), ..self },
            Deed::Halve { .. } => Self { halved: true, ..self },
            Deed::Flip | Deed::Press { .. } | Deed::Move(_) => self,
        }
    }
}

/// What holds as the steps go by.
pub(crate) struct Sequence<'a> {
    input: InputText<'a>,
    lies: BTreeMap<&'a str, Lies>,
    earliest: f64,
}

impl<'a> Sequence<'a> {
    /// Before the first step.
    pub(crate) fn new(input: InputText<'a>, foods: impl Iterator<Item = &'a str>) -> Self {
        let raw = Lies { at: At::Waiting, halved: false };
        Self { input, lies: foods.map(|id| (id, raw)).collect(), earliest: 0.0 }
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
            Action::Do(Command::Toss { .. }) if !self.lies.values().any(|l| l.at == At::Pan) => self.input.error(
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
        let fits = |id: &&String| self.lies.get(id.as_str()).is_some_and(|l| l.fits(deed));
        if !target.foods.iter().any(|id| fits(&id)) {
            let halved = target.foods.iter().any(|id| self.lies.get(id.as_str()).is_some_and(|l| l.halved));
            let (place, remedy) = match deed {
                Deed::Put { .. } => {
                    ("is in the pan already", "a food in the pan cannot be put in again: rest it first")
                }
                Deed::Halve { .. } if halved => ("is cut in halves already", "leave this step out: a food is cut once"),
                Deed::Halve { .. } => ("does not lie on the board", "rest it on the board before this step"),
                _ => ("is not in the pan", "put it into the pan before this step"),
            };
            return self.input.error(at, format!("\"{name}\" {place} at this step"), remedy);
        }
        for id in &target.foods {
            self.lies.entry(id.as_str()).and_modify(|l| *l = l.after(deed));
        }
        Ok(())
    }
}

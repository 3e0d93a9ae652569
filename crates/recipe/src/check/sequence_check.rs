//! Checks of a recipe's steps before the cook: foods are where a step needs them, times increase, there is an end.

use std::collections::BTreeMap;

use crate::action::food_action::Requirement;
use crate::action::{Action, FoodAction, PanAction, RepeatEnd};
use crate::recipe::{Step, Target, Trigger};
use saute_kitchen::hands::command::RestOn;
use saute_schema::{InputError, InputText};

/// Where a food is before a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum At {
    Waiting,
    Pan,
    Resting(RestOn),
}

/// State of a food before a step.
#[derive(Clone, Copy, Debug)]
struct FoodState {
    at: At,
    halved: bool,
}

impl FoodState {
    /// Returns true if the food meets a requirement.
    fn meets(self, requirement: Requirement) -> bool {
        match requirement {
            Requirement::OutsidePan => self.at != At::Pan,
            Requirement::InPan => self.at == At::Pan,
            Requirement::WholeOnBoard => matches!(self.at, At::Resting(RestOn::Board | RestOn::Foil)) && !self.halved,
        }
    }

    /// Returns the state after an action.
    fn after(self, action: FoodAction) -> Self {
        match action {
            FoodAction::Put { .. } => Self { at: At::Pan, ..self },
            FoodAction::Rest(on) => Self { at: At::Resting(on), ..self },
            FoodAction::Halve { .. } => Self { halved: true, ..self },
            FoodAction::Flip | FoodAction::Press { .. } | FoodAction::Baste { .. } | FoodAction::Move(_) => self,
        }
    }
}

/// State of the foods and of the time while the steps are checked in order.
pub(crate) struct Sequence<'a> {
    input: InputText<'a>,
    foods: BTreeMap<&'a str, FoodState>,
    /// Earliest time at which the next step can start [s].
    earliest: f64,
}

impl<'a> Sequence<'a> {
    /// Returns the state before the first step.
    pub(crate) fn new(input: InputText<'a>, foods: impl Iterator<Item = &'a str>) -> Self {
        let raw = FoodState { at: At::Waiting, halved: false };
        Self { input, foods: foods.map(|id| (id, raw)).collect(), earliest: 0.0 }
    }

    /// Checks all steps; `places` are their offsets in the text [bytes].
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
        self.earliest = start
            + match &step.action {
                Action::Repeat(repeat) => repeat.shortest_s(),
                action => action.duration_s(),
            };
        Ok(())
    }

    fn check_place(&mut self, at: usize, action: &'a Action) -> Result<(), InputError> {
        match action {
            Action::Each(target, action) => self.check_target(at, target, *action),
            Action::Pan(PanAction::Toss { .. }) if !self.foods.values().any(|food| food.at == At::Pan) => self
                .input
                .error(at, "there is nothing in the pan to toss at this step", "put a food into the pan before it"),
            // It must also be possible after itself.
            Action::Repeat(repeat) => {
                let again = repeat.end != RepeatEnd::Times(1);
                self.check_place(at, &repeat.action)?;
                if again { self.check_place(at, &repeat.action) } else { Ok(()) }
            }
            Action::Pan(_) | Action::End => Ok(()),
        }
    }

    /// Checks that a single food meets the requirement of an action, or at least one food of a group.
    fn check_target(&mut self, at: usize, target: &'a Target, action: FoodAction) -> Result<(), InputError> {
        let requirement = action.requirement();
        if !self.any(target, |food| food.meets(requirement)) {
            let halved = self.any(target, |food| food.halved);
            let (place, remedy) = unmet(requirement, halved);
            return self.input.error(at, format!("\"{}\" {place} at this step", target.name), remedy);
        }
        for id in &target.foods {
            self.foods.entry(id.as_str()).and_modify(|food| *food = food.after(action));
        }
        Ok(())
    }

    /// Returns true if a condition is true for any food of a target.
    fn any(&self, target: &Target, condition: impl Fn(FoodState) -> bool) -> bool {
        target.foods.iter().any(|id| self.foods.get(id.as_str()).is_some_and(|food| condition(*food)))
    }
}

/// Returns message and remedy for a requirement that no food meets; `halved` is true if one of them is cut already.
fn unmet(requirement: Requirement, halved: bool) -> (&'static str, &'static str) {
    match requirement {
        Requirement::OutsidePan => ("is in the pan already", "a food in the pan cannot be put in again: rest it first"),
        Requirement::WholeOnBoard if halved => ("is cut in halves already", "leave this step out: a food is cut once"),
        Requirement::WholeOnBoard => ("does not lie on the board", "rest it on the board before this step"),
        Requirement::InPan => ("is not in the pan", "put it into the pan before this step"),
    }
}

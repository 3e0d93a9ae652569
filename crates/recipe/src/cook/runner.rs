//! Runs the steps of a recipe in a kitchen.

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use crate::action::food_action::Destination;
use crate::action::{Action, FoodAction, RepeatEnd};
use crate::condition::Condition;
use crate::cook::repeating::{Progress, Repeating};
use crate::cook::step_record::StepRecord;
use crate::cook::watch::{Watch, is_passed};
use crate::recipe::{ALL, Recipe, Target, Trigger};
use saute_kitchen::TICK_S;
use saute_kitchen::hands::command::{Command, Refused};
use saute_kitchen::kitchen::Kitchen;
use saute_schema::InputError;

/// The reason for which a cook stopped.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum StoppedBy {
    /// The recipe's `end`.
    End,
    /// The recipe's `max_s`.
    MaxS,
    /// A hand: a person took over from the recipe, or left.
    Hand,
}

/// Runs a recipe's steps in order.
#[derive(Clone, Debug)]
pub struct Runner {
    pub(super) recipe: Arc<Recipe>,
    pub(super) next: usize,
    pub(super) begun: bool,
    pub(super) ready_at: f64,
    pub(super) armed: Option<Watch>,
    pub(super) repeating: Option<Repeating>,
    pub(super) warnings: Vec<String>,
    pub(super) stopped: Option<StoppedBy>,
}

/// Times closer than this count as equal [s] (chosen: far below a tick, far above rounding).
const SAME_TIME: f64 = 1e-6;

impl Runner {
    /// Returns a runner before the first step.
    pub fn new(recipe: Arc<Recipe>) -> Self {
        Self {
            recipe,
            next: 0,
            begun: false,
            ready_at: 0.0,
            armed: None,
            repeating: None,
            warnings: Vec::new(),
            stopped: None,
        }
    }

    /// Returns the recipe.
    pub fn recipe(&self) -> &Arc<Recipe> {
        &self.recipe
    }

    /// Returns the reason for which the cook stopped; none while it goes on.
    pub fn stopped(&self) -> Option<StoppedBy> {
        self.stopped
    }

    /// Returns the warnings on steps that were reached.
    pub fn warnings(&self) -> &[String] {
        &self.warnings
    }

    /// Returns the index of the next step.
    pub fn waiting_step(&self) -> usize {
        self.next
    }

    /// Returns the action of the next step; none after the last one.
    pub fn waiting_action(&self) -> Option<&Action> {
        Some(&self.recipe.steps.get(self.next)?.action)
    }

    /// Returns the end of the previous action, from which `after_s` counts [s].
    pub fn ready_at_s(&self) -> f64 {
        self.ready_at
    }

    /// Fires every step that is due now and returns these steps. Call it between ticks.
    ///
    /// # Errors
    ///
    /// Returns an error with the line of a step that cannot be carried out.
    pub fn poll(&mut self, kitchen: &mut Kitchen) -> Result<Vec<StepRecord>, InputError> {
        if !self.begun {
            self.begun = true;
            self.check_room(kitchen)?;
        }
        let mut fired = Vec::new();
        while self.stopped.is_none() {
            if let Some(repeating) = self.repeating.take() {
                match self.go_on(repeating, kitchen)? {
                    Progress::Fired(record) => fired.push(record),
                    Progress::Done => {}
                    Progress::Waits if kitchen.time_s() > self.recipe.max_s - SAME_TIME => {
                        self.stopped = Some(StoppedBy::MaxS);
                    }
                    Progress::Waits => break,
                }
            } else if kitchen.time_s() > self.recipe.max_s - SAME_TIME && !self.due_at_the_end(kitchen) {
                self.stopped = Some(StoppedBy::MaxS);
            } else if self.due(kitchen)? {
                fired.extend(self.fire(kitchen)?);
            } else {
                break;
            }
        }
        Ok(fired)
    }

    /// Checks that every group fits into the empty pan, before the cook starts.
    fn check_room(&self, kitchen: &Kitchen) -> Result<(), InputError> {
        for (step, entry) in self.recipe.steps.iter().enumerate() {
            if let Action::Each(target, action @ FoodAction::Put { at, heap: false }) = &entry.action
                && target.group
                && target.name != ALL
            {
                let places = kitchen.free_places(&target.foods, *at);
                self.all_fit(step, &target.name, [places.len(), target.foods.len()], *action)?;
            }
        }
        Ok(())
    }

    /// Returns true if a step is due at `max_s` itself.
    fn due_at_the_end(&mut self, kitchen: &Kitchen) -> bool {
        matches!(self.due(kitchen), Ok(true))
    }

    fn due(&mut self, kitchen: &Kitchen) -> Result<bool, InputError> {
        let now = kitchen.time_s();
        // A step with `at_s` fires at its time; all others wait until the hands have finished the previous step.
        let at_its_time = matches!(self.recipe.steps[self.next].trigger, Trigger::At(_));
        if kitchen.busy() && !at_its_time {
            return Ok(false);
        }
        if now < self.ready_at - SAME_TIME {
            return Ok(false);
        }
        let recipe = Arc::clone(&self.recipe);
        match &recipe.steps[self.next].trigger {
            Trigger::At(s) => {
                if now > s + TICK_S - SAME_TIME && self.armed.is_none() {
                    return Err(self.error(
                        self.next,
                        format!("at_s = {s} is already past: the step before it ended at {now:.1} s"),
                        "use a later at_s, or after_s",
                    ));
                }
                self.armed = Some(Watch::default());
                Ok(now >= s - SAME_TIME)
            }
            Trigger::After(s) => Ok(now >= self.ready_at + s - SAME_TIME),
            Trigger::When(condition) => Ok(self.is_met(condition, kitchen)),
        }
    }

    /// Returns true once the condition of the next step has been met since the step was reached.
    fn is_met(&mut self, condition: &Condition, kitchen: &Kitchen) -> bool {
        if self.armed.is_none() && is_passed(condition, kitchen) {
            self.warnings.push(condition.warning(self.recipe.steps[self.next].line));
        }
        self.armed.get_or_insert_default().look(condition, kitchen)
    }

    /// Fires the next step; returns its record. A repeated action begins without one, and each repetition has its own.
    fn fire(&mut self, kitchen: &mut Kitchen) -> Result<Option<StepRecord>, InputError> {
        let action = self.recipe.steps[self.next].action.clone();
        let now = kitchen.time_s();
        self.armed = None;
        if matches!(action, Action::Repeat(_)) {
            self.repeating = Some(Repeating::since(now));
            return Ok(None);
        }
        let record = self.carry_out(kitchen, action)?;
        if record.action == Action::End {
            self.stopped = Some(StoppedBy::End);
        } else {
            self.next += 1;
        }
        Ok(Some(record))
    }

    /// Carries out an action now; returns its record.
    fn carry_out(&mut self, kitchen: &mut Kitchen, action: Action) -> Result<StepRecord, InputError> {
        let now = kitchen.time_s();
        let foods = match &action {
            Action::Pan(action) => self.apply(kitchen, &action.command()).map(|()| Vec::new()),
            Action::Each(target, action) => self.fire_each(kitchen, target, *action),
            Action::Repeat(_) | Action::End => Ok(Vec::new()),
        }?;
        self.ready_at = now + action.duration_s();
        Ok(StepRecord::new(action, foods, now))
    }

    /// Goes on with the repeated action of the next step: ends it, carries it out again, or waits.
    fn go_on(&mut self, mut repeating: Repeating, kitchen: &mut Kitchen) -> Result<Progress, InputError> {
        let recipe = Arc::clone(&self.recipe);
        let Action::Repeat(repeat) = &recipe.steps[self.next].action else { return Ok(Progress::Done) };
        if repeating.ends(repeat, kitchen) {
            self.ready_at = self.ready_at.max(kitchen.time_s());
            self.next += 1;
            return Ok(Progress::Done);
        }
        let due = kitchen.time_s() >= self.ready_at.max(repeating.last_s + repeat.every_s) - SAME_TIME;
        let progress = if due && !kitchen.busy() {
            repeating.count(kitchen.time_s());
            Progress::Fired(self.carry_out(kitchen, (*repeat.action).clone())?)
        } else {
            Progress::Waits
        };
        self.repeating = Some(repeating);
        Ok(progress)
    }

    fn apply(&self, kitchen: &mut Kitchen, command: &Command) -> Result<(), InputError> {
        let refused = |r: Refused| self.error(self.next, r.to_string(), "change this step or the ones before it");
        kitchen.apply(command).map_err(refused)
    }

    /// Applies the action to each food that meets its requirement; returns the ids of these foods.
    fn fire_each(&self, kitchen: &mut Kitchen, target: &Target, action: FoodAction) -> Result<Vec<String>, InputError> {
        let foods = concerned(kitchen, target, action);
        let places = self.places(kitchen, target, &foods, action)?;
        for (food, at) in foods.iter().zip(places) {
            self.apply(kitchen, &action.command(food.clone(), at))?;
        }
        Ok(foods)
    }

    /// Returns the place of each food [m]: side by side for a group, otherwise the place of the recipe.
    fn places(
        &self,
        kitchen: &Kitchen,
        target: &Target,
        foods: &[String],
        action: FoodAction,
    ) -> Result<Vec<[f64; 2]>, InputError> {
        let places = match action.destination() {
            Some(Destination { at, side_by_side: true }) if target.group => kitchen.free_places(foods, at),
            Some(Destination { at, .. }) => vec![at; foods.len()],
            None => vec![[0.0; 2]; foods.len()],
        };
        self.all_fit(self.next, &target.name, [places.len(), foods.len()], action)?;
        Ok(places)
    }

    /// Returns an error if fewer foods fit than the action has.
    fn all_fit(&self, step: usize, name: &str, [fit, all]: [usize; 2], action: FoodAction) -> Result<(), InputError> {
        if fit == all {
            return Ok(());
        }
        let message = format!("not all of \"{name}\" find room on the floor of the pan: {fit} of {all} fit");
        let heap = format!("write put = {{ food = \"{name}\", heap = true }} to drop them onto each other");
        let other = if matches!(action, FoodAction::Move(_)) { "take something out before this step" } else { &heap };
        Err(self.error(step, message, &format!("choose fewer or smaller pieces, or {other}")))
    }

    fn error(&self, step: usize, message: String, remedy: &str) -> InputError {
        let line = self.recipe.steps[step].line;
        InputError { file: self.recipe.file.clone(), line, message, remedy: remedy.to_owned() }
    }

    /// Returns the time of the next repetition [s], while an action is repeated.
    pub fn next_repetition_s(&self) -> Option<f64> {
        let Action::Repeat(repeat) = self.waiting_action()? else { return None };
        Some(self.repeating.as_ref()?.last_s + repeat.every_s)
    }

    /// Returns the next step and its trigger in English: `flip steak at 90 s`.
    pub fn waiting_for(&self) -> String {
        let Some(step) = self.recipe.steps.get(self.next) else { return "the end".into() };
        if let (Action::Repeat(repeat), Some(at)) = (&step.action, self.next_repetition_s()) {
            let end = match &repeat.end {
                RepeatEnd::Times(times) => format!("{times} times"),
                RepeatEnd::Until(condition) => format!("until {}", condition.words()),
            };
            return format!("{} at {at:.0} s, {end}", name(&repeat.action));
        }
        let what = match &step.action {
            Action::Repeat(repeat) => format!("repeat {}", name(&repeat.action)),
            action => name(action),
        };
        match &step.trigger {
            Trigger::At(s) => format!("{what} at {s:.0} s"),
            Trigger::After(s) => format!("{what} at {:.0} s", self.ready_at + s),
            Trigger::When(condition) => format!("{what} when {}", condition.words()),
        }
    }
}

/// Returns the key of an action with its target: `flip steak`.
fn name(action: &Action) -> String {
    action.target().map_or_else(|| action.name().to_owned(), |t| format!("{} {}", action.name(), t.name))
}

/// Returns the foods of a target on which an action acts: of a group, those that meet its requirement. If none does, it
/// returns all of them, and the kitchen's refusal states the reason.
fn concerned(kitchen: &Kitchen, target: &Target, action: FoodAction) -> Vec<String> {
    let fits = |id: &&String| kitchen.piece(id).is_some_and(|p| action.requirement().met_by(p));
    let fitting: Vec<String> = target.foods.iter().filter(fits).cloned().collect();
    if target.group && !fitting.is_empty() { fitting } else { target.foods.clone() }
}

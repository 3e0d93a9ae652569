//! Runs the steps of a recipe against a kitchen.

use std::sync::Arc;

use serde::Serialize;

use crate::command::{Command, Refused};
use crate::input_error::InputError;
use crate::kitchen::Kitchen;
use crate::recipe::{Action, Quantity, Recipe, Trigger};
use crate::{TICK_S, celsius};

/// Why a cook stopped.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum StoppedBy {
    /// The recipe's last step.
    End,
    /// The recipe's `max_s`.
    MaxS,
}

/// A step that was carried out.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct StepRecord {
    /// When [s].
    pub time_s: f64,
    /// Name of the action's key.
    pub action: &'static str,
    /// The food, if it has one.
    pub target: Option<String>,
    /// Its value: watts, seconds, a place or a surface.
    pub value: serde_json::Value,
}

/// Differences below this are rounding [K, kg] (chosen: area means of an even temperature are off by 1e-12).
const SAME_VALUE: f64 = 1e-7;

/// Walks through a recipe's steps.
#[derive(Clone, Debug)]
pub struct Runner {
    recipe: Arc<Recipe>,
    next: usize,
    ready_at: f64,
    armed: Option<f64>,
    stopped: Option<StoppedBy>,
}

/// Times closer than this count as equal [s] (chosen: far below a tick, far above rounding).
const SAME_TIME: f64 = 1e-6;

impl Runner {
    /// Starts at the first step.
    pub fn new(recipe: Arc<Recipe>) -> Self {
        Self { recipe, next: 0, ready_at: 0.0, armed: None, stopped: None }
    }

    /// The recipe.
    pub fn recipe(&self) -> &Arc<Recipe> {
        &self.recipe
    }

    /// Why the cook stopped, once it has.
    pub fn stopped(&self) -> Option<StoppedBy> {
        self.stopped
    }

    /// Index of the step that is waited for.
    pub fn waiting_step(&self) -> usize {
        self.next
    }

    /// Fires every step that is due now and returns what was done; call it between ticks.
    pub fn poll(&mut self, kitchen: &mut Kitchen) -> Result<Vec<StepRecord>, InputError> {
        let mut fired = Vec::new();
        while self.stopped.is_none() {
            if kitchen.time_s() > self.recipe.max_s - SAME_TIME && !self.due_at_the_end(kitchen) {
                self.stopped = Some(StoppedBy::MaxS);
            } else if self.due(kitchen)? {
                fired.push(self.fire(kitchen)?);
            } else {
                break;
            }
        }
        Ok(fired)
    }

    /// At `max_s` itself a step that is due still counts.
    fn due_at_the_end(&mut self, kitchen: &Kitchen) -> bool {
        matches!(self.due(kitchen), Ok(true))
    }

    fn due(&mut self, kitchen: &Kitchen) -> Result<bool, InputError> {
        let now = kitchen.time_s();
        if now < self.ready_at - SAME_TIME {
            return Ok(false);
        }
        let recipe = Arc::clone(&self.recipe);
        match &recipe.steps[self.next].trigger {
            Trigger::At(s) => {
                if now > s + TICK_S - SAME_TIME && self.armed.is_none() {
                    return Err(self.error(
                        format!("at_s = {s} is already past: the step before it ended at {now:.1} s"),
                        "use a later at_s, or after_s",
                    ));
                }
                self.armed = Some(0.0);
                Ok(now >= s - SAME_TIME)
            }
            Trigger::After(s) => Ok(now >= self.ready_at + s - SAME_TIME),
            Trigger::Pan(value) => Ok(self.crossed(kitchen.pan_temperature() - value)),
            Trigger::Food { food, quantity, value } => {
                let reading = kitchen.piece(food).map_or(f64::NAN, |p| match quantity {
                    Quantity::Core => p.core(),
                    Quantity::Top => p.face(false),
                    Quantity::Bottom => p.face(true),
                    Quantity::Mass => p.mass(),
                });
                Ok(self.crossed(reading - value))
            }
        }
    }

    /// Whether the difference has changed sign since the step was armed, or is zero but for rounding.
    fn crossed(&mut self, difference: f64) -> bool {
        let before = *self.armed.get_or_insert(difference);
        difference.abs() < SAME_VALUE || (before < 0.0) != (difference < 0.0)
    }

    fn fire(&mut self, kitchen: &mut Kitchen) -> Result<StepRecord, InputError> {
        let action = self.recipe.steps[self.next].action.clone();
        let now = kitchen.time_s();
        if let Action::Do(command) = &action {
            kitchen.apply(command).map_err(|refused| self.refused(&refused))?;
        }
        let record = record(&action, now);
        self.ready_at = now + action.duration_s();
        self.armed = None;
        if action == Action::End {
            self.stopped = Some(StoppedBy::End);
        } else {
            self.next += 1;
        }
        Ok(record)
    }

    fn refused(&self, refused: &Refused) -> InputError {
        self.error(refused.to_string(), "change this step or the ones before it")
    }

    fn error(&self, message: String, remedy: &str) -> InputError {
        let line = self.recipe.steps[self.next].line;
        InputError { file: self.recipe.file.clone(), line, message, remedy: remedy.to_owned() }
    }

    /// What the waiting step waits for, in words.
    pub fn waiting_for(&self) -> String {
        let Some(step) = self.recipe.steps.get(self.next) else { return "the end".into() };
        let (key, target, _) = parts(&step.action);
        let what = target.map_or_else(|| key.to_owned(), |t| format!("{key} {t}"));
        match &step.trigger {
            Trigger::At(s) => format!("{what} at {s:.0} s"),
            Trigger::After(s) => format!("{what} at {:.0} s", self.ready_at + s),
            Trigger::Pan(t) => format!("{what} when the pan reaches {:.0} °C", celsius(*t)),
            Trigger::Food { food, quantity, value } => match quantity {
                Quantity::Mass => format!("{what} when {food} weighs {:.0} g", value * 1e3),
                Quantity::Core => format!("{what} when the core of {food} reaches {:.0} °C", celsius(*value)),
                Quantity::Top => format!("{what} when the top of {food} reaches {:.0} °C", celsius(*value)),
                Quantity::Bottom => format!("{what} when the underside of {food} reaches {:.0} °C", celsius(*value)),
            },
        }
    }
}

fn parts(action: &Action) -> (&'static str, Option<&str>, serde_json::Value) {
    match action {
        Action::Do(Command::Hob(power)) => ("hob_w", None, (*power).into()),
        Action::Do(Command::Put { food, at }) => ("put", Some(food), serde_json::json!([at[0] * 1e3, at[1] * 1e3])),
        Action::Do(Command::Flip { food }) => ("flip", Some(food), serde_json::Value::Null),
        Action::Do(Command::Rest { food, on }) => ("rest", Some(food), serde_json::json!(on)),
        Action::Do(Command::MovePan { at, lift }) => {
            ("move_pan", None, serde_json::json!({ "at_mm": [at[0] * 1e3, at[1] * 1e3], "lift_mm": lift * 1e3 }))
        }
        Action::Do(Command::Cool { for_s }) => ("cool", None, (*for_s).into()),
        Action::Do(Command::Oil { kind, mass }) => ("oil_g", Some(kind), (1e3 * mass).into()),
        Action::Do(Command::Butter(mass)) => ("butter_g", None, (1e3 * mass).into()),
        Action::Do(Command::Water(mass)) => ("water_g", None, (1e3 * mass).into()),
        Action::Do(Command::Lid(on)) => ("lid", None, (*on).into()),
        Action::End => ("end", None, true.into()),
    }
}

fn record(action: &Action, time_s: f64) -> StepRecord {
    let (action, target, value) = parts(action);
    StepRecord { time_s: rounded(time_s), action, target: target.map(str::to_owned), value }
}

/// A time without the noise of binary fractions [s].
pub(crate) fn rounded(time_s: f64) -> f64 {
    libm::round(time_s * 1000.0) / 1000.0
}

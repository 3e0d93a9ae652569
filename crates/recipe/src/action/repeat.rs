//! An action that is repeated in a fixed rhythm.

use serde_json::{Value, json};

use crate::action::Action;
use crate::condition::Condition;

/// An action that is carried out again and again; the first time one period after the step is due.
#[derive(Clone, Debug, PartialEq)]
pub struct Repeat {
    /// The action.
    pub action: Box<Action>,
    /// Period, from the start of one repetition to that of the next [s].
    pub every_s: f64,
    /// When it ends.
    pub end: RepeatEnd,
}

/// When a repeated action ends.
#[derive(Clone, Debug, PartialEq)]
pub enum RepeatEnd {
    /// After so many repetitions [-].
    Times(u32),
    /// Once a condition is true, at any tick; without a repetition if it is true from the start.
    Until(Condition),
}

impl Repeat {
    /// Returns the rhythm and the action in the units of the recipe, as JSON.
    pub fn value(&self) -> Value {
        let target = self.action.target().map(|target| target.name.as_str());
        let mut value = json!({
            "action": self.action.name(),
            "target": target,
            "value": self.action.value(),
            "every_s": self.every_s,
        });
        match &self.end {
            RepeatEnd::Times(times) => value["times"] = (*times).into(),
            RepeatEnd::Until(condition) => value["until"] = condition.json(),
        }
        value
    }

    /// Returns the repetition in English: `repeat flip steak every 30 s until the core of steak reaches 50 °C`.
    pub fn words(&self) -> String {
        let end = match &self.end {
            RepeatEnd::Times(1) => "once".to_owned(),
            RepeatEnd::Times(times) => format!("{times} times"),
            RepeatEnd::Until(condition) => format!("until {}", condition.words()),
        };
        format!("repeat {} every {} s {end}", self.action.words(), self.every_s)
    }

    /// Returns the shortest time from the start of the step to the end of its last repetition [s].
    pub fn shortest_s(&self) -> f64 {
        match self.end {
            RepeatEnd::Times(times) => f64::from(times) * self.every_s + self.action.duration_s(),
            RepeatEnd::Until(_) => 0.0,
        }
    }
}

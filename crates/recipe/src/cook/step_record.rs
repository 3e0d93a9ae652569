//! The record of a step, as summaries and reports show it.

use serde::{Serialize, Serializer};
use serde_json::Value;

use crate::action::Action;

/// A step that was carried out. As JSON it has the keys `time_s`, `action`, `target`, `foods` and `value`.
#[derive(Clone, Debug, PartialEq)]
pub struct StepRecord {
    /// Time [s].
    pub time_s: f64,
    /// The action.
    pub action: Action,
    /// Ids of the foods on which it acted.
    pub foods: Vec<String>,
}

/// A [`StepRecord`] as JSON.
#[derive(Serialize)]
struct StepJson<'a> {
    time_s: f64,
    action: &'static str,
    target: Option<&'a str>,
    foods: &'a [String],
    value: Value,
}

impl StepRecord {
    pub(crate) fn new(action: Action, foods: Vec<String>, time_s: f64) -> Self {
        Self { time_s: rounded(time_s), action, foods }
    }
}

impl Serialize for StepRecord {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let json = StepJson {
            time_s: self.time_s,
            action: self.action.name(),
            target: self.action.target().map(|target| target.name.as_str()),
            foods: &self.foods,
            value: self.action.value(),
        };
        json.serialize(serializer)
    }
}

/// Returns a time without the rounding error of binary fractions [s].
pub fn rounded(time_s: f64) -> f64 {
    libm::round(time_s * 1000.0) / 1000.0
}

//! Moments of a cook at which its summary is read.

use saute_recipe::ActionKind;
use saute_recipe::step_record::StepRecord;
use schemars::JsonSchema;
use serde::Deserialize;

/// A moment of a cook.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq)]
#[serde(try_from = "MomentEntry")]
pub(super) enum Moment {
    /// A time [s].
    Time(f64),
    /// Some time after a step with an action has fired.
    Step {
        action: ActionKind,
        /// Number of that step among those with the same action, from 1.
        nth: usize,
        /// Time after the step [s].
        after_s: f64,
    },
}

/// A moment as a file states it: `{ s = 150 }`, or `{ step = "flip", nth = 2, after_s = 60 }`.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct MomentEntry {
    /// Time [s].
    s: Option<f64>,
    /// Action of a step.
    step: Option<String>,
    /// Number of that step among those with the same action, from 1.
    nth: Option<usize>,
    /// Time after the step [s].
    after_s: Option<f64>,
}

impl TryFrom<MomentEntry> for Moment {
    type Error = String;

    fn try_from(entry: MomentEntry) -> Result<Self, String> {
        let after_s = entry.after_s.unwrap_or(0.0);
        let in_time = |s: f64| s.is_finite() && s >= 0.0;
        match (entry.s, entry.step, entry.nth) {
            (Some(s), None, None) if in_time(s) && entry.after_s.is_none() => Ok(Self::Time(s)),
            (None, Some(step), nth) if in_time(after_s) && nth != Some(0) => {
                let found = ActionKind::ALL.into_iter().find(|kind| kind.name() == step);
                let action = found.ok_or_else(|| format!("step = \"{step}\" is not an action; saute list actions"))?;
                Ok(Self::Step { action, nth: nth.unwrap_or(1), after_s })
            }
            _ => {
                Err("a moment is { s = 150 } or { step = \"flip\", nth = 2, after_s = 60 }, from 0 s and from 1".into())
            }
        }
    }
}

impl Moment {
    /// Returns the time of the moment [s] after the steps that have fired; none before its step has fired.
    pub fn time_s(&self, fired: &[StepRecord]) -> Option<f64> {
        match self {
            Self::Time(s) => Some(*s),
            Self::Step { action, nth, after_s } => {
                let step = fired.iter().filter(|step| step.action.kind() == *action).nth(nth - 1)?;
                Some(step.time_s + after_s)
            }
        }
    }
}

//! Cooks of one recipe with one parameter varied, and the trends that their results follow.

use schemars::JsonSchema;
use serde::Deserialize;

use crate::cook_case::moment::{Moment, MomentEntry};

/// Values of a mark in the recipe's text.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct Sweep {
    /// The mark, as `@hob_w@`.
    pub replace: String,
    /// What replaces it, one cook for each.
    pub values: Vec<SweepValue>,
}

/// A value that replaces the mark.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(untagged)]
pub(super) enum SweepValue {
    Number(f64),
    Text(String),
}

impl Sweep {
    /// Returns the text with each value in place of the mark, after a label such as `hob_w = 500`.
    pub fn variants(&self, text: &str) -> Vec<(String, String)> {
        let name = self.replace.trim_matches('@');
        let variant = |value: &SweepValue| {
            let value = match value {
                SweepValue::Number(number) => number.to_string(),
                SweepValue::Text(text) => text.clone(),
            };
            (format!("{name} = {value}"), text.replace(&self.replace, &value))
        };
        self.values.iter().map(variant).collect()
    }
}

/// A promise on a number of the summary along the values of the sweep.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct TrendEntry {
    /// Name of the quantity.
    pub quantity: String,
    /// Pointer to its number in the summary.
    pub pointer: String,
    /// Pointer to a number that is subtracted.
    pub less: Option<String>,
    /// Moment of the reading; the end of the cook by default.
    #[schemars(with = "Option<MomentEntry>")]
    pub at: Option<Moment>,
    /// Its unit.
    pub unit: String,
    /// Direction of the values.
    pub direction: Direction,
    /// Largest change against the direction, in the number's unit.
    pub slack: Option<f64>,
    /// The same, relative to the best value before it [%].
    pub slack_pct: Option<f64>,
    /// Leaves out the cooks in which another number is at its limit or beyond.
    pub while_below: Option<Guard>,
}

/// A number of the summary and its limit.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct Guard {
    /// Pointer to the number in the summary.
    pub pointer: String,
    /// Its limit.
    pub limit: f64,
}

/// Direction of a trend.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq, Eq)]
#[serde(rename_all = "snake_case")]
pub(super) enum Direction {
    NotFalling,
    NotRising,
}

impl Direction {
    /// Returns the promise in words.
    pub fn promise(self) -> &'static str {
        match self {
            Self::NotFalling => "never falls",
            Self::NotRising => "never rises",
        }
    }

    /// Returns the largest change against the direction from the best value before it, in the unit of the values or, if
    /// `relative`, in percent of that value; none for fewer than two values.
    pub fn largest_breach(self, values: &[f64], relative: bool) -> Option<f64> {
        let (first, rest) = values.split_first().filter(|(_, rest)| !rest.is_empty())?;
        let sign = if self == Self::NotFalling { 1.0 } else { -1.0 };
        let breach = |(best, most): (f64, f64), value: &f64| {
            let change = sign * (best - value);
            // No change is none in percent of zero, too.
            let share = if relative && change != 0.0 { 100.0 * change / best.abs() } else { change };
            // NaN is kept, and fails.
            let most = if share <= most || most.is_nan() { most } else { share };
            (if change < 0.0 { *value } else { best }, most)
        };
        Some(rest.iter().fold((*first, 0.0), breach).1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_breach_is_measured_from_the_best_value_before_it() {
        let flux = [2.32, 2.42, 1.83, 1.81, 3.01];
        let fall = Direction::NotFalling.largest_breach(&flux, false).expect("values");
        assert!((fall - (2.42 - 1.81)).abs() < 1e-12, "{fall}");
        let share = Direction::NotFalling.largest_breach(&flux, true).expect("values");
        assert!((share - 100.0 * (2.42 - 1.81) / 2.42).abs() < 1e-9, "{share}");
        let rise = Direction::NotRising.largest_breach(&[475.0, 429.0, 469.0], true).expect("values");
        assert!((rise - 100.0 * 40.0 / 429.0).abs() < 1e-9, "{rise}");
        assert_eq!(Direction::NotRising.largest_breach(&[3.0, 2.0, 2.0], true), Some(0.0));
        assert_eq!(Direction::NotFalling.largest_breach(&[0.0, 0.0, 5.0], true), Some(0.0));
        // Small steps add up.
        let slow = Direction::NotFalling.largest_breach(&[100.0, 99.5, 99.0, 98.5], true).expect("values");
        assert!((slow - 1.5).abs() < 1e-9, "{slow}");
    }

    #[test]
    fn one_value_is_no_trend_and_nan_is_kept() {
        assert_eq!(Direction::NotFalling.largest_breach(&[1.0], false), None);
        let bad = Direction::NotFalling.largest_breach(&[1.0, f64::NAN, 2.0], false);
        assert!(bad.is_some_and(f64::is_nan), "{bad:?}");
    }
}

//! Learning curves: a median for each trial and condition.

use std::collections::BTreeSet;

use serde::Serialize;

use super::bootstrap::Interval;
use super::{Quantity, Trial};
use crate::log_row::LogRow;

/// A point of a learning curve.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Point {
    /// What is shown.
    pub quantity: Quantity,
    /// Condition.
    pub condition: String,
    /// Number of the phase.
    pub phase: u32,
    /// Number of the trial over all phases.
    pub number: u32,
    /// Participants with this trial.
    pub n: usize,
    /// Participants of the condition without it.
    pub missing: usize,
    /// Median with its interval; none where nobody has the trial.
    pub interval: Option<Interval>,
}

pub(super) fn points(
    rows: &[LogRow],
    trials: &[Trial],
    conditions: &BTreeSet<&str>,
    most: u32,
    seed: u64,
) -> Vec<Point> {
    let mut points = Vec::new();
    for quantity in Quantity::ALL {
        for (place, condition) in conditions.iter().enumerate() {
            let all: BTreeSet<&str> =
                rows.iter().filter(|row| row.condition == *condition).map(|row| row.participant.as_str()).collect();
            for number in 1..=most {
                let of = |trial: &&Trial| trial.number == number && trial.row.condition == *condition;
                let here: Vec<&Trial> = trials.iter().filter(of).collect();
                let values: Vec<f64> = here.iter().filter_map(|trial| quantity.of(trial.row)).collect();
                let phase = trials.iter().find(|trial| trial.number == number).map_or(0, |trial| trial.row.phase);
                points.push(Point {
                    quantity,
                    condition: (*condition).to_owned(),
                    phase,
                    number,
                    n: values.len(),
                    missing: all.len().saturating_sub(values.len()),
                    interval: Interval::of(&values, &[seed, quantity as u64, place as u64, u64::from(number)]),
                });
            }
        }
    }
    points
}

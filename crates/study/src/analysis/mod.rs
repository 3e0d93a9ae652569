//! Analysis of logs: learning curves, and what changed after the cook at a real stove.
//!
//! Medians have bootstrap intervals: participants are drawn with replacement, the median of each draw is taken, and the interval contains the
//! middle 90 % of 2000 of them (percentile method). Draws are seeded: the same logs give the same numbers.

mod before_after;
mod bootstrap;
mod curve;

use std::collections::{BTreeMap, BTreeSet};

use serde::Serialize;

pub use self::before_after::{Change, Span};
pub use self::bootstrap::{INTERVAL, Interval};
pub use self::curve::Point;
use super::log_row::{LogRow, RowKind};

/// What is analysed of a trial.
#[derive(Clone, Copy, Debug, Eq, Ord, PartialEq, PartialOrd, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Quantity {
    /// The score [points].
    Score,
    /// The share that the goal counts [%].
    TargetSharePct,
}

/// Why logs are not analysed together.
#[derive(Clone, Debug, Eq, PartialEq, thiserror::Error)]
pub enum Mixed {
    /// There is no row.
    #[error("there is no row in the logs")]
    Empty,
    /// They are of several studies.
    #[error("the logs are of several studies: {0}; analyse each on its own")]
    Studies(String),
    /// They are of several versions of a protocol.
    #[error("the protocol was changed between the logs (checksums {0}); analyse each version on its own")]
    Versions(String),
    /// People and simulated participants are mixed.
    #[error("some participants are people and some are simulated; analyse them on their own")]
    Simulated,
    /// A participant is there twice.
    #[error("trial {1} of phase {2} of participant {0} is there twice; name each log once")]
    Twice(String, u32, u32),
}

/// A participant in the logs.
#[derive(Clone, Debug, Eq, PartialEq, Serialize)]
pub struct Taker {
    /// Code.
    pub participant: String,
    /// Condition.
    pub condition: String,
    /// Trials that are there.
    pub trials: usize,
    /// Trials that others have and this one lacks.
    pub missing_trials: usize,
    /// Values entered at the stove and answers.
    pub answers: usize,
}

/// What came of a study.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Analysis {
    /// Id of the study.
    pub study: String,
    /// Checksum of its protocol.
    pub protocol: String,
    /// True if the participants are simulated.
    pub simulated: bool,
    /// Seed of the bootstrap.
    pub seed: u64,
    /// The participants, by their codes.
    pub participants: Vec<Taker>,
    /// Learning curves: points by quantity, condition and trial.
    pub curves: Vec<Point>,
    /// Comparisons before and after the cook at a real stove; none where there was none, or no trial on one side of it.
    pub changes: Vec<Change>,
    /// Number of the trial, over all phases, after which there was a cook at a real stove.
    pub real_after: Vec<u32>,
}

/// A trial of a participant.
#[derive(Clone, Debug)]
pub(super) struct Trial<'a> {
    pub(super) row: &'a LogRow,
    /// Number over all phases, from 1.
    pub(super) number: u32,
}

impl Quantity {
    /// All of them.
    pub const ALL: [Self; 2] = [Self::Score, Self::TargetSharePct];

    /// Reads it of a trial.
    pub fn of(self, row: &LogRow) -> Option<f64> {
        match self {
            Self::Score => row.score,
            Self::TargetSharePct => row.target_share_pct,
        }
    }

    /// Its name in tables.
    pub fn id(self) -> &'static str {
        match self {
            Self::Score => "score",
            Self::TargetSharePct => "target_share_pct",
        }
    }
}

impl Analysis {
    /// Analyses rows of logs, with a seed for the bootstrap.
    ///
    /// # Errors
    ///
    /// If the rows do not belong together.
    pub fn of(rows: &[LogRow], seed: u64) -> Result<Self, Mixed> {
        belong_together(rows)?;
        let first = rows.first().ok_or(Mixed::Empty)?;
        let numbers = numbers(rows);
        let trials: Vec<Trial> = trials(rows, &numbers);
        let real_after = real_after(rows, &numbers);
        let conditions: BTreeSet<&str> = rows.iter().map(|row| row.condition.as_str()).collect();
        Ok(Self {
            study: first.study.clone(),
            protocol: first.protocol.clone(),
            simulated: first.simulated,
            seed,
            participants: takers(rows, numbers.len()),
            curves: curve::points(rows, &trials, &conditions, numbers.len() as u32, seed),
            changes: real_after
                .iter()
                .flat_map(|after| before_after::changes(&trials, &conditions, *after, seed))
                .collect(),
            real_after,
        })
    }

    /// Names of the conditions.
    pub fn conditions(&self) -> Vec<String> {
        let conditions: BTreeSet<&String> = self.participants.iter().map(|taker| &taker.condition).collect();
        conditions.into_iter().cloned().collect()
    }
}

fn belong_together(rows: &[LogRow]) -> Result<(), Mixed> {
    let distinct = |value: &dyn Fn(&LogRow) -> String| rows.iter().map(value).collect::<BTreeSet<_>>();
    let joined = |values: BTreeSet<String>| values.into_iter().collect::<Vec<_>>().join(", ");
    let studies = distinct(&|row| row.study.clone());
    let versions = distinct(&|row| row.protocol.clone());
    match (studies.len(), versions.len(), distinct(&|row| row.simulated.to_string()).len()) {
        (0, ..) => Err(Mixed::Empty),
        (2.., ..) => Err(Mixed::Studies(joined(studies))),
        (_, 2.., _) => Err(Mixed::Versions(joined(versions))),
        (.., 2..) => Err(Mixed::Simulated),
        _ => no_trial_twice(rows),
    }
}

fn no_trial_twice(rows: &[LogRow]) -> Result<(), Mixed> {
    let mut known = BTreeSet::new();
    for row in rows.iter().filter(|row| row.kind == RowKind::Trial) {
        let trial = row.trial.unwrap_or_default();
        if !known.insert((&row.participant, row.phase, trial)) {
            return Err(Mixed::Twice(row.participant.clone(), trial, row.phase));
        }
    }
    Ok(())
}

/// Numbers the trials over all phases: phase and trial to the number, from 1.
fn numbers(rows: &[LogRow]) -> BTreeMap<(u32, u32), u32> {
    let trials = rows.iter().filter(|row| row.kind == RowKind::Trial);
    let found: BTreeSet<(u32, u32)> = trials.filter_map(|row| Some((row.phase, row.trial?))).collect();
    found.into_iter().zip(1..).collect()
}

fn trials<'a>(rows: &'a [LogRow], numbers: &BTreeMap<(u32, u32), u32>) -> Vec<Trial<'a>> {
    let of = |row: &'a LogRow| {
        let number = *numbers.get(&(row.phase, row.trial?))?;
        (row.kind == RowKind::Trial).then_some(Trial { row, number })
    };
    rows.iter().filter_map(of).collect()
}

/// Numbers of the last trials before each phase at a real stove.
fn real_after(rows: &[LogRow], numbers: &BTreeMap<(u32, u32), u32>) -> Vec<u32> {
    let real: BTreeSet<u32> = rows.iter().filter(|row| row.kind == RowKind::Entry).map(|row| row.phase).collect();
    let last = |phase: u32| numbers.iter().filter(|((of, _), _)| *of < phase).map(|(_, number)| *number).max();
    let found: BTreeSet<u32> = real.into_iter().filter_map(last).collect();
    found.into_iter().collect()
}

fn takers(rows: &[LogRow], most: usize) -> Vec<Taker> {
    let codes: BTreeSet<(&String, &String)> = rows.iter().map(|row| (&row.participant, &row.condition)).collect();
    let of = |(participant, condition): (&String, &String)| {
        let count = |is: &dyn Fn(RowKind) -> bool| {
            rows.iter().filter(|row| row.participant == *participant && is(row.kind)).count()
        };
        let trials = count(&|kind| kind == RowKind::Trial);
        Taker {
            participant: participant.clone(),
            condition: condition.clone(),
            trials,
            missing_trials: most.saturating_sub(trials),
            answers: count(&|kind| matches!(kind, RowKind::Entry | RowKind::Answer)),
        }
    };
    codes.into_iter().map(of).collect()
}

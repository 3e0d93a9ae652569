//! What changed after the cook at a real stove: the same participants before and after it.

use std::collections::{BTreeMap, BTreeSet};

use saute_kitchen::heat::sorted::Sorted;
use serde::Serialize;

use super::bootstrap::Interval;
use super::{Quantity, Trial};

/// Which trials are compared.
#[derive(Clone, Copy, Debug, Eq, Ord, PartialEq, PartialOrd, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Span {
    /// The last trial before and the first one after it.
    Nearest,
    /// The means of all trials of the phase before and of the phase after it.
    Phases,
}

/// A comparison of participants who have trials on both sides.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Change {
    /// What is compared.
    pub quantity: Quantity,
    /// Which trials.
    pub span: Span,
    /// Condition; none for all participants together.
    pub condition: Option<String>,
    /// Number of the last trial before the cook.
    pub after_trial: u32,
    /// Participants with trials on both sides.
    pub n: usize,
    /// Participants with trials on one side only.
    pub missing: usize,
    /// Medians before and after.
    pub before: f64,
    /// Median after.
    pub after: f64,
    /// Median of each participant's own difference, with its interval.
    pub difference: Interval,
}

/// Values of a participant on both sides.
#[derive(Clone, Debug, Default)]
struct Sides {
    condition: String,
    before: Vec<(u32, f64)>,
    after: Vec<(u32, f64)>,
}

impl Sides {
    fn pair(&self, span: Span) -> Option<(f64, f64)> {
        let mean = |values: &[(u32, f64)]| {
            (!values.is_empty()).then(|| values.iter().map(|(_, v)| v).sum::<f64>() / values.len() as f64)
        };
        match span {
            Span::Nearest => {
                let last = self.before.iter().max_by_key(|(number, _)| *number)?;
                let first = self.after.iter().min_by_key(|(number, _)| *number)?;
                Some((last.1, first.1))
            }
            Span::Phases => Some((mean(&self.before)?, mean(&self.after)?)),
        }
    }
}

pub(super) fn changes(trials: &[Trial], conditions: &BTreeSet<&str>, after_trial: u32, seed: u64) -> Vec<Change> {
    let mut changes = Vec::new();
    for quantity in Quantity::ALL {
        let sides = sides(trials, quantity, after_trial);
        let groups = conditions.iter().map(|condition| Some(*condition)).chain([None]);
        for (place, condition) in groups.enumerate() {
            for span in [Span::Nearest, Span::Phases] {
                let seeds = [seed, 1000 + quantity as u64, place as u64, span as u64];
                changes.extend(change(&sides, (quantity, span, condition, after_trial), &seeds));
            }
        }
    }
    changes
}

fn change(
    sides: &BTreeMap<&str, Sides>,
    (quantity, span, condition, after_trial): (Quantity, Span, Option<&str>, u32),
    seeds: &[u64],
) -> Option<Change> {
    let group = sides.values().filter(|sides| condition.is_none_or(|condition| sides.condition == condition));
    let (all, pairs): (Vec<_>, Vec<_>) =
        (group.clone().collect(), group.filter_map(|sides| sides.pair(span)).collect());
    let of = |value: &dyn Fn(&(f64, f64)) -> f64| pairs.iter().map(value).collect::<Vec<f64>>();
    Some(Change {
        quantity,
        span,
        condition: condition.map(str::to_owned),
        after_trial,
        n: pairs.len(),
        missing: all.len() - pairs.len(),
        before: Sorted::new(of(&|pair| pair.0)).median()?,
        after: Sorted::new(of(&|pair| pair.1)).median()?,
        difference: Interval::of(&of(&|pair| pair.1 - pair.0), seeds)?,
    })
}

/// The phases next to the cook, on both sides, of each participant.
fn sides<'a>(trials: &[Trial<'a>], quantity: Quantity, after_trial: u32) -> BTreeMap<&'a str, Sides> {
    let phase_of = |number: u32| trials.iter().find(|trial| trial.number == number).map(|trial| trial.row.phase);
    let (before, after) = (phase_of(after_trial), phase_of(after_trial + 1));
    let mut sides: BTreeMap<&str, Sides> = BTreeMap::new();
    for trial in trials {
        let Some(value) = quantity.of(trial.row) else { continue };
        let of = sides.entry(&trial.row.participant).or_default();
        of.condition.clone_from(&trial.row.condition);
        match trial.row.phase {
            phase if Some(phase) == before => of.before.push((trial.number, value)),
            phase if Some(phase) == after => of.after.push((trial.number, value)),
            _ => {}
        }
    }
    sides
}

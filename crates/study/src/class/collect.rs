//! What a class did: many results together.

use std::collections::{BTreeMap, BTreeSet};

use saute_kitchen::heat::sorted::Sorted;
use serde::Serialize;

use super::histogram::{Bar, bars};
use super::result_row::{MOST_QUESTIONS, ResultRow};

/// What a class did.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ClassSummary {
    /// Each scenario, and each version of it.
    pub scenarios: Vec<ScenarioSummary>,
}

/// What a class did in a scenario.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ScenarioSummary {
    /// Id of the scenario.
    pub scenario: String,
    /// Checksum of its text: results of a scenario that was changed are summed up on their own.
    pub checksum: String,
    /// Number of results.
    pub results: usize,
    /// Number of students with a code.
    pub students: usize,
    /// Results without a code.
    pub without_code: usize,
    /// Results that met the goal.
    pub met: usize,
    /// Median of the mark that students see [points of 100]; none where a result is from before it was kept.
    pub median_mark: Option<f64>,
    /// Median of the score, which may be negative [points].
    pub median_score: f64,
    /// Median of the share of the goal [%].
    pub median_target_share_pct: f64,
    /// The questions that were answered.
    pub questions: Vec<QuestionSummary>,
}

/// What a class answered to a question.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct QuestionSummary {
    /// Number of the question, from 1.
    pub question: usize,
    /// Answers.
    pub answers: usize,
    /// Answers whose truth is known.
    pub compared: usize,
    /// Truths that were left out: files of before note the present where the question was about the end, and the food had not rested.
    pub early_truths: usize,
    /// Median of the distance from the truth, in the unit of the question.
    pub median_error: Option<f64>,
    /// How answers and truths spread.
    pub bars: Vec<Bar>,
}

impl ClassSummary {
    /// Merges results: rows in the order of scenario and student, each once and without truths that were noted too early, and what the
    /// class did.
    pub fn of(rows: &[ResultRow]) -> (Vec<ResultRow>, Self) {
        let mut merged: Vec<ResultRow> = Vec::new();
        for row in rows {
            if !merged.contains(row) {
                merged.push(row.clone());
            }
        }
        merged.sort_by(|a, b| (&a.scenario, &a.checksum, &a.student).cmp(&(&b.scenario, &b.checksum, &b.student)));
        let merged: Vec<Believed> = merged.into_iter().map(Believed::of).collect();
        let mut groups: BTreeMap<(&str, &str), Vec<&Believed>> = BTreeMap::new();
        for one in &merged {
            groups.entry((&one.row.scenario, &one.row.checksum)).or_default().push(one);
        }
        let scenarios = groups.values().filter_map(|rows| ScenarioSummary::of(rows)).collect();
        (merged.into_iter().map(|one| one.row).collect(), Self { scenarios })
    }
}

/// A result without the truths that were noted too early.
struct Believed {
    row: ResultRow,
    /// The places of the questions that lost one.
    early: Vec<usize>,
}

impl Believed {
    fn of(mut row: ResultRow) -> Self {
        let early = row.early_truths();
        early.iter().for_each(|place| row.forget_truth(*place));
        Self { row, early }
    }
}

impl ScenarioSummary {
    fn of(believed: &[&Believed]) -> Option<Self> {
        let rows: Vec<&ResultRow> = believed.iter().map(|one| &one.row).collect();
        let first = rows.first()?;
        let codes: BTreeSet<&String> = rows.iter().filter_map(|row| row.student.as_ref()).collect();
        let of = |value: &dyn Fn(&ResultRow) -> f64| Sorted::new(rows.iter().map(|row| value(row)).collect()).median();
        Some(Self {
            scenario: first.scenario.clone(),
            checksum: first.checksum.clone(),
            results: rows.len(),
            students: codes.len(),
            without_code: rows.iter().filter(|row| row.student.is_none()).count(),
            met: rows.iter().filter(|row| row.is_met).count(),
            median_mark: rows
                .iter()
                .map(|row| row.mark)
                .collect::<Option<Vec<f64>>>()
                .and_then(|marks| Sorted::new(marks).median()),
            median_score: of(&|row| row.score)?,
            median_target_share_pct: of(&|row| row.target_share_pct)?,
            questions: (0..MOST_QUESTIONS).filter_map(|place| question(believed, place)).collect(),
        })
    }
}

fn question(rows: &[&Believed], place: usize) -> Option<QuestionSummary> {
    let early_truths = rows.iter().filter(|one| one.early.contains(&place)).count();
    let pairs: Vec<[Option<f64>; 2]> = rows.iter().map(|one| one.row.questions()[place]).collect();
    let answers: Vec<f64> = pairs.iter().filter_map(|[answer, _]| *answer).collect();
    let truths: Vec<f64> = pairs.iter().filter_map(|[_, truth]| *truth).collect();
    let errors: Vec<f64> = pairs.iter().filter_map(|[answer, truth]| Some(((*answer)? - (*truth)?).abs())).collect();
    (!answers.is_empty()).then(|| QuestionSummary {
        question: place + 1,
        answers: answers.len(),
        compared: errors.len(),
        early_truths,
        median_error: Sorted::new(errors).median(),
        bars: bars(&answers, &truths),
    })
}

//! What a student hands in: one row.

use serde::{Deserialize, Serialize};

use super::lesson::Asked;
use super::scenario::Scenario;
use crate::csv_rows::Rows;
use crate::log_row::LogError;
use crate::measures::Measures;
use crate::participant::Participant;

/// Questions that a scenario may have: a row has two columns for each.
pub const MOST_QUESTIONS: usize = 4;

/// The result of a student.
#[derive(Clone, Debug, Default, Deserialize, PartialEq, Serialize)]
#[serde(deny_unknown_fields)]
pub struct ResultRow {
    /// Id of the scenario.
    pub scenario: String,
    /// Checksum of the scenario's text.
    pub checksum: String,
    /// Code of the student; empty where there is none.
    pub student: Option<String>,
    /// Id of the goal.
    pub goal: String,
    /// True if the goal was met.
    pub is_met: bool,
    /// Score [points].
    pub score: f64,
    /// Share of the goal [%].
    pub target_share_pct: f64,
    /// Share of the section beyond the class of the goal [%].
    pub beyond_pct: f64,
    /// Mean thickness of the grey band of both faces [mm].
    pub grey_band_mm: f64,
    /// Highest temperature of the core [°C].
    pub core_peak_c: f64,
    /// Browned share of the faces [%].
    pub crust_pct: f64,
    /// Charred share of the faces [%].
    pub charred_pct: f64,
    /// Mass that was lost [%].
    pub lost_pct: f64,
    /// Electrical energy of the hob [kJ].
    pub energy_kj: f64,
    /// Number of flips.
    pub flips: u32,
    /// When the food went into the pan [simulated s].
    pub put_s: Option<f64>,
    /// When it was taken out [simulated s].
    pub out_s: Option<f64>,
    /// When the lesson ended [simulated s].
    pub end_s: f64,
    /// Answers and truths of the questions, in the order of the scenario; of a class its place from 0.
    pub q1_answer: Option<f64>,
    /// See [`Self::q1_answer`].
    pub q1_truth: Option<f64>,
    /// See [`Self::q1_answer`].
    pub q2_answer: Option<f64>,
    /// See [`Self::q1_answer`].
    pub q2_truth: Option<f64>,
    /// See [`Self::q1_answer`].
    pub q3_answer: Option<f64>,
    /// See [`Self::q1_answer`].
    pub q3_truth: Option<f64>,
    /// See [`Self::q1_answer`].
    pub q4_answer: Option<f64>,
    /// See [`Self::q1_answer`].
    pub q4_truth: Option<f64>,
    /// Mark [points]; results of before it was kept have none.
    #[serde(default)]
    pub mark: Option<f64>,
    /// Whether the food had rested; results of before it was kept do not have it.
    #[serde(default)]
    pub rest: Option<RestKind>,
}

/// Whether the food of a lesson had rested when its result was read.
#[derive(Clone, Copy, Debug, Deserialize, Eq, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum RestKind {
    /// It rested before the student's eyes.
    Seen,
    /// The student ended the lesson while it rested; it was cooked on in a copy until it had rested.
    CookedOn,
    /// It had not: questions about the end have no truth.
    None,
}

impl ResultRow {
    pub(super) fn of(scenario: &Scenario, student: Option<&Participant>, measures: &Measures, asked: &[Asked]) -> Self {
        let of = |place: usize| asked.get(place).copied().unwrap_or_default();
        let (answer, truth) = (|place| of(place).answer, |place| of(place).truth.map(Measures::rounded));
        let m = measures.to_two_places();
        Self {
            scenario: scenario.id.clone(),
            checksum: format!("{:08x}", scenario.checksum),
            student: student.map(ToString::to_string),
            goal: scenario.goal.goal.id.clone(),
            is_met: m.is_met,
            score: m.score,
            target_share_pct: m.target_share_pct,
            beyond_pct: m.beyond_pct,
            grey_band_mm: m.grey_band_mm,
            core_peak_c: m.core_peak_c,
            crust_pct: m.crust_pct,
            charred_pct: m.charred_pct,
            lost_pct: m.lost_pct,
            energy_kj: m.energy_kj,
            flips: m.flips,
            put_s: m.put_s,
            out_s: m.out_s,
            end_s: m.end_s,
            q1_answer: answer(0),
            q1_truth: truth(0),
            q2_answer: answer(1),
            q2_truth: truth(1),
            q3_answer: answer(2),
            q3_truth: truth(2),
            q4_answer: answer(3),
            q4_truth: truth(3),
            mark: Some(m.mark),
            rest: None,
        }
    }

    /// Answers and truths of the questions.
    pub fn questions(&self) -> [[Option<f64>; 2]; MOST_QUESTIONS] {
        [
            [self.q1_answer, self.q1_truth],
            [self.q2_answer, self.q2_truth],
            [self.q3_answer, self.q3_truth],
            [self.q4_answer, self.q4_truth],
        ]
    }

    pub(super) fn forget_truth(&mut self, place: usize) {
        let truths = [&mut self.q1_truth, &mut self.q2_truth, &mut self.q3_truth, &mut self.q4_truth];
        if let Some(truth) = truths.into_iter().nth(place) {
            *truth = None;
        }
    }

    /// The row as one line to paste into a sheet: values between tabs, in the order of the columns.
    pub fn line(&self) -> String {
        let csv = to_csv(std::slice::from_ref(self));
        csv.lines().nth(1).unwrap_or_default().replace(',', "\t")
    }
}

/// Returns rows as CSV with a header.
pub fn to_csv(rows: &[ResultRow]) -> String {
    let mut writer = csv::Writer::from_writer(Vec::new());
    // Memory takes all that is written, and every field of a row has a text.
    let _ = rows.iter().try_for_each(|row| writer.serialize(row));
    writer.into_inner().ok().and_then(|bytes| String::from_utf8(bytes).ok()).unwrap_or_default()
}

/// Most rows of a file (chosen: a large school).
const MOST_ROWS: usize = 20_000;

/// Columns of ids.
const IDS: [&str; 3] = ["scenario", "checksum", "goal"];

/// Reads the text of a student's or a class's file.
///
/// # Errors
///
/// If a line is no result.
pub fn from_csv(file: &str, text: &str) -> Result<Vec<ResultRow>, LogError> {
    let columns = columns();
    let rows = Rows {
        what: "result of a lesson",
        remedy: "name files that a lesson has given",
        columns: &columns,
        new: 2,
        ids: &IDS,
        most: MOST_ROWS,
    };
    let rows: Vec<ResultRow> = rows.read(file, text)?;
    let is_code = |row: &ResultRow| row.student.as_ref().is_none_or(|code| code.parse::<Participant>().is_ok());
    match rows.iter().position(|row| !is_code(row)) {
        None => Ok(rows),
        Some(at) => {
            let message = "its student is no code of 1 to 12 letters, digits and hyphens".to_owned();
            Err(LogError { file: file.to_owned(), line: at as u64 + 2, message })
        }
    }
}

/// Names of the columns, in their order.
fn columns() -> Vec<String> {
    let header = to_csv(&[ResultRow::default()]);
    header.lines().next().unwrap_or_default().split(',').map(str::to_owned).collect()
}

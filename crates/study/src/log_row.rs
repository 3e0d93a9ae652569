//! A row of a participant's log, and logs as CSV.

use serde::{Deserialize, Serialize};

use super::protocol_file::Information;
use crate::csv_rows::Rows;

/// What a row is about.
#[derive(Clone, Copy, Debug, Deserialize, Eq, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum RowKind {
    /// The participant agreed to take part.
    Consent,
    /// A trial in the simulator.
    Trial,
    /// A value of a cook at a real stove.
    Entry,
    /// An answer to a question.
    Answer,
}

/// A row of a participant's log. What a kind of row does not have is empty. [`COLUMNS`](super::dictionary::COLUMNS) states what each
/// column means; its order is that of the fields.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
#[serde(deny_unknown_fields)]
pub struct LogRow {
    /// Id of the protocol.
    pub study: String,
    /// Checksum of the protocol's text.
    pub protocol: String,
    /// Code.
    pub participant: String,
    /// True for a simulated participant.
    pub simulated: bool,
    /// Condition.
    pub condition: String,
    /// Number of the phase, from 1; 0 for the consent.
    pub phase: u32,
    /// What the row is about.
    pub kind: RowKind,
    /// Wall time since the study was begun, in this run of the program [s].
    pub elapsed_s: f64,
    /// Time of day of the start of the program, if the protocol requests it.
    pub started: Option<String>,
    /// Number of the trial in its phase, from 1.
    pub trial: Option<u32>,
    /// Information that was in force.
    pub information: Option<Information>,
    /// Id of the goal.
    pub goal: Option<String>,
    /// Score [points].
    pub score: Option<f64>,
    /// True if the goal was met.
    pub is_met: Option<bool>,
    /// Share of the goal [%].
    pub target_share_pct: Option<f64>,
    /// Share of the section beyond the class of the goal [%].
    pub beyond_pct: Option<f64>,
    /// Mean thickness of the grey band of both faces [mm].
    pub grey_band_mm: Option<f64>,
    /// Highest temperature of the core [°C].
    pub core_peak_c: Option<f64>,
    /// Browned share of the faces [%].
    pub crust_pct: Option<f64>,
    /// Charred share of the faces [%].
    pub charred_pct: Option<f64>,
    /// Mass that was lost [%].
    pub lost_pct: Option<f64>,
    /// Electrical energy of the hob [kJ].
    pub energy_kj: Option<f64>,
    /// Number of flips.
    pub flips: Option<u32>,
    /// When the food went into the pan [simulated s].
    pub put_s: Option<f64>,
    /// When it was taken out [simulated s].
    pub out_s: Option<f64>,
    /// When the trial ended [simulated s].
    pub end_s: Option<f64>,
    /// Wall time of the trial [s].
    pub trial_wall_s: Option<f64>,
    /// File of the session, if it is kept.
    pub session: Option<String>,
    /// What was entered or asked.
    pub item: Option<String>,
    /// The value, if it is a number.
    pub value: Option<f64>,
    /// The value, if it is a word.
    pub text: Option<String>,
    /// Mark [points]; logs of before it was kept have none.
    #[serde(default)]
    pub mark: Option<f64>,
    /// Speed that was set: simulated time over wall time [-]; logs of before it was kept have none of these three.
    #[serde(default)]
    pub speed_set: Option<f64>,
    /// Median of the speed that was held [-].
    #[serde(default)]
    pub speed_held_median: Option<f64>,
    /// Simulated time that is missing at the end of the trial [s].
    #[serde(default)]
    pub behind_s: Option<f64>,
    /// Devices that held the pan or the turner, in the order of their names.
    #[serde(default)]
    pub devices: Option<String>,
}

/// A log that cannot be read.
#[derive(Clone, Debug, Eq, PartialEq, thiserror::Error)]
#[error("{file}:{line}: {message}")]
pub struct LogError {
    /// The file.
    pub file: String,
    /// Line, from 1.
    pub line: u64,
    /// What is wrong, and what to do.
    pub message: String,
}

/// Most rows of a log (chosen: far above fifty trials in twenty phases).
const MOST_ROWS: usize = 20_000;

/// Returns rows as CSV, with the header or without it.
pub fn to_csv(rows: &[LogRow], with_header: bool) -> String {
    let mut writer = csv::WriterBuilder::new().has_headers(with_header).from_writer(Vec::new());
    // Memory takes all that is written, and every field of a row has a text.
    let _ = rows.iter().try_for_each(|row| writer.serialize(row));
    writer.into_inner().ok().and_then(|bytes| String::from_utf8(bytes).ok()).unwrap_or_default()
}

/// Returns the text of a log with all columns of today, if it has the columns of before: rows of today are appended to nothing else.
pub fn with_all_columns(text: &str, rows: &[LogRow]) -> Option<String> {
    let whole = to_csv(rows, true);
    let header = |text: &str| text.trim_start_matches('\u{feff}').lines().next().map(str::to_owned);
    (!rows.is_empty() && header(text) != header(&whole)).then_some(whole)
}

/// Columns of ids.
const IDS: [&str; 6] = ["study", "protocol", "participant", "condition", "goal", "item"];

/// Reads the text of a log.
///
/// # Errors
///
/// If a line is no row of a log.
pub fn from_csv(file: &str, text: &str) -> Result<Vec<LogRow>, LogError> {
    let columns: Vec<String> = super::dictionary::COLUMNS.iter().map(|column| column.name.to_owned()).collect();
    let rows = Rows {
        what: "row of a study's log",
        remedy: "name files that `saute study` has written",
        columns: &columns,
        new: 5,
        ids: &IDS,
        most: MOST_ROWS,
    };
    rows.read(file, text)
}

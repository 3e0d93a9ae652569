//! Expected against computed.

use serde::Serialize;

use crate::lab::case::Case;
use crate::lab::case_file::Quantity;
use crate::lab::report::LabReport;

/// What an expectation is about.
#[derive(Clone, Debug, PartialEq)]
pub enum Subject {
    /// A probe at a time [s].
    Probe(String, f64),
    /// A number of the whole run.
    Whole(Quantity),
}

/// An expected value.
#[derive(Clone, Debug, PartialEq)]
pub struct Expectation {
    /// What it is about.
    pub subject: Subject,
    /// Expected value.
    pub value: f64,
    /// Largest departure.
    pub tolerance: f64,
}

/// What came of one expectation.
#[derive(Clone, Debug, Serialize)]
pub struct Verdict {
    /// Name of the case.
    pub name: String,
    /// Where the expected value comes from.
    pub source: String,
    /// Which quantity.
    pub quantity: String,
    /// Its unit.
    pub unit: String,
    /// Expected value.
    pub expected: f64,
    /// Largest departure.
    pub tolerance: f64,
    /// Computed value; none where the run did not produce it.
    pub got: Option<f64>,
    /// Computed less expected.
    pub error: Option<f64>,
    /// Whether it holds.
    pub pass: bool,
}

/// Compares a run with what its case expects.
pub fn verdicts(case: &Case, report: &LabReport) -> Vec<Verdict> {
    case.expectations.iter().map(|e| verdict(case, report, e)).collect()
}

fn verdict(case: &Case, report: &LabReport, expectation: &Expectation) -> Verdict {
    let (quantity, unit, got) = read(report, &expectation.subject);
    let error = got.map(|g| g - expectation.value);
    Verdict {
        name: case.name.clone(),
        source: case.source.clone(),
        quantity,
        unit: unit.to_owned(),
        expected: expectation.value,
        tolerance: expectation.tolerance,
        got,
        error,
        pass: error.is_some_and(|e| e.abs() <= expectation.tolerance),
    }
}

fn read(report: &LabReport, subject: &Subject) -> (String, &'static str, Option<f64>) {
    match subject {
        Subject::Probe(name, time) => {
            let series = report.probes.get(name);
            let near = |[t, _]: &&[f64; 2]| (t - time).abs() < 1e-6 * time.max(1.0);
            (format!("{name} at {time} s"), "°C", series.and_then(|s| s.iter().find(near)).map(|[_, c]| *c))
        }
        Subject::Whole(Quantity::StoppedAt) => ("stopped".into(), "s", report.stopped_at_s),
        Subject::Whole(Quantity::Absorbed) => ("heat taken up".into(), "J", Some(report.absorbed_j)),
        Subject::Whole(Quantity::Max) => ("highest".into(), "°C", Some(report.max_c)),
        Subject::Whole(Quantity::Min) => ("lowest".into(), "°C", Some(report.min_c)),
        Subject::Whole(Quantity::Probe) => ("probe".into(), "°C", None),
    }
}

//! Verdicts: computed values against expected ones.

use serde::Serialize;

use crate::case::Case;
use crate::case::Quantity;
use crate::result::evidence::Evidence;
use crate::result::report::LabReport;

/// Subject of an expectation.
#[derive(Clone, Debug, PartialEq)]
pub enum Subject {
    /// Temperature or flux of a probe at a time [s].
    Probe(Quantity, String, f64),
    /// A number of the whole run.
    Whole(Quantity),
}

/// An expected value.
#[derive(Clone, Debug, PartialEq)]
pub struct Expectation {
    /// Subject.
    pub subject: Subject,
    /// Expected value.
    pub value: f64,
    /// Largest absolute error.
    pub tolerance: f64,
}

/// The verdict on one expectation.
#[derive(Clone, Debug, Serialize)]
pub struct Verdict {
    /// Name of the case.
    pub name: String,
    /// Source of the expected value.
    pub source: String,
    /// Kind of evidence; `None` if the case does not state it.
    pub evidence: Option<Evidence>,
    /// Name of the quantity.
    pub quantity: String,
    /// Its unit.
    pub unit: String,
    /// Expected value.
    pub expected: f64,
    /// Largest absolute error.
    pub tolerance: f64,
    /// Computed value; `None` if the run did not produce it.
    pub got: Option<f64>,
    /// Computed less expected.
    pub error: Option<f64>,
    /// True if the absolute error is within the tolerance; `None` for information, which passes and fails nothing.
    pub pass: Option<bool>,
    /// Why the value is known to miss its tolerance; `None` if it should hold.
    pub known_miss: Option<String>,
}

impl Verdict {
    /// Returns true if the value misses its tolerance without a recorded miss, or is within it although a miss is recorded.
    pub fn falls_short(&self) -> bool {
        self.pass == Some(self.known_miss.is_some())
    }

    /// Returns true if the value misses its tolerance, as is known.
    pub fn misses_as_known(&self) -> bool {
        self.pass == Some(false) && self.known_miss.is_some()
    }

    /// Returns the absolute error over the tolerance [-]; infinite without a computed value.
    pub fn error_share(&self) -> f64 {
        // Without a tolerance, an exact value has no error.
        let share = |error: f64| if error == 0.0 { 0.0 } else { error.abs() / self.tolerance };
        self.error.map(share).filter(|share| !share.is_nan()).unwrap_or(f64::INFINITY)
    }
}

/// Compares the report of a run with the expectations of its case.
///
/// ```
/// use saute_lab::{Case, run, validation_cases, verdicts};
///
/// let library = saute_kitchen::Library::embedded()?;
/// let case = Case::parse(&validation_cases()["convection-slab-bi-1"], "convection-slab-bi-1.toml", &library)?;
/// let verdicts = verdicts(&case, &run(&case, || 0.0));
/// assert!(!verdicts.is_empty() && verdicts.iter().all(|v| v.pass == Some(true)));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn verdicts(case: &Case, report: &LabReport) -> Vec<Verdict> {
    case.expectations.iter().map(|e| verdict(case, report, e)).collect()
}

fn verdict(case: &Case, report: &LabReport, expectation: &Expectation) -> Verdict {
    let (quantity, unit, got) = read(report, &expectation.subject);
    let error = got.map(|g| g - expectation.value);
    Verdict {
        name: case.name.clone(),
        source: case.source.clone(),
        evidence: case.evidence,
        quantity,
        unit: unit.to_owned(),
        expected: expectation.value,
        tolerance: expectation.tolerance,
        got,
        error,
        pass: case.evidence.unwrap_or(Evidence::Exact).judge(error.is_some_and(|e| e.abs() <= expectation.tolerance)),
        known_miss: None,
    }
}

fn read(report: &LabReport, subject: &Subject) -> (String, &'static str, Option<f64>) {
    match subject {
        Subject::Probe(quantity, name, time) => {
            let (all, what, unit) = match quantity {
                Quantity::Flux => (&report.flux, "flux at ", "W/m²"),
                _ => (&report.probes, "", "°C"),
            };
            let near = |[t, _]: &&[f64; 2]| (t - time).abs() < 1e-6 * time.max(1.0);
            let got = all.get(name).and_then(|s| s.iter().find(near)).map(|[_, value]| *value);
            (format!("{what}{name} at {time} s"), unit, got)
        }
        Subject::Whole(quantity) => whole(report, *quantity),
    }
}

fn whole(report: &LabReport, quantity: Quantity) -> (String, &'static str, Option<f64>) {
    let other = report.compared.as_ref().and_then(|c| c.stopped_at_s);
    let (name, unit, got) = match quantity {
        Quantity::Probe => ("probe", "°C", None),
        Quantity::Flux => ("flux", "W/m²", None),
        Quantity::StoppedAt => ("stopped", "s", report.stopped_at_s),
        Quantity::Absorbed => ("heat taken up", "J", Some(report.absorbed_j)),
        Quantity::Max => ("highest", "°C", Some(report.max_c)),
        Quantity::Min => ("lowest", "°C", Some(report.min_c)),
        Quantity::EvaporatedKgM2 => ("evaporated", "kg/m²", report.evaporated_kg_m2),
        Quantity::EvaporatedG => ("evaporated", "g", report.evaporated_g),
        Quantity::CrustMm => ("crust", "mm", report.crust_mm),
        Quantity::CorePeak => ("core, highest", "°C", report.core_peak_c),
        Quantity::CorePeakAt => ("core, highest, when", "s", report.core_peak_at_s),
        Quantity::FirstPhaseEnded => ("pulled", "s", report.phases_ended_s.first().copied()),
        Quantity::DrippedG => ("dripped", "g", report.dripped_g),
        Quantity::LostPct => ("mass lost", "%", report.lost_pct),
        Quantity::SectionShrunkPct => ("section shrunk by", "%", report.section_shrunk_pct),
        Quantity::ThicknessShrunkPct => ("thickness shrunk by", "%", report.thickness_shrunk_pct),
        Quantity::ContactHighest => ("contact, highest", "W/m²K", highest(report).map(|c| c[1])),
        Quantity::ContactHighestAt => ("contact, highest, when", "s", highest(report).map(|c| c[0])),
        Quantity::ContactLast => ("contact, at the end", "W/m²K", report.contact_w_m2k.last().map(|c| c[1])),
        Quantity::ContactLowest => {
            let lowest = report.contact_w_m2k.iter().map(|c| c[1]).min_by(f64::total_cmp);
            ("contact, lowest", "W/m²K", lowest)
        }
        Quantity::StopRatio => ("time over time", "-", other.zip(report.stopped_at_s).map(|(o, s)| o / s)),
    };
    (name.to_owned(), unit, got)
}

/// Returns time [s] and value [W/(m²·K)] of the highest contact conductance to a pan.
fn highest(report: &LabReport) -> Option<[f64; 2]> {
    report.contact_w_m2k.iter().copied().max_by(|a, b| a[1].total_cmp(&b[1]))
}

//! Verdicts grouped by their kind of evidence, worst first.

use saute_lab::{Evidence, Verdict};
use serde::Serialize;

use super::CaseRun;

/// The values of one kind of evidence, largest error over tolerance first.
pub struct Group<'a> {
    /// Kind of evidence.
    pub evidence: Evidence,
    /// Each verdict with the case that it belongs to.
    pub rows: Vec<(&'a CaseRun, &'a Verdict)>,
}

/// The summary of a group, as `--json` prints it.
#[derive(Serialize)]
pub struct GroupSummary {
    evidence: Evidence,
    /// Number of values.
    values: usize,
    /// Number of values that hold; null for information.
    hold: Option<usize>,
    /// Number of values that miss their tolerance, as is known.
    known_misses: usize,
    /// The value with the largest error over its tolerance; null for information.
    worst: Option<Worst>,
}

#[derive(Serialize)]
struct Worst {
    name: String,
    quantity: String,
    /// Absolute error over tolerance [-]; null if there is no computed value.
    error_over_tolerance: f64,
}

/// Returns the groups that have values, strongest evidence first.
pub fn groups(runs: &[CaseRun]) -> Vec<Group<'_>> {
    let group = |evidence: Evidence| {
        let of_kind = runs.iter().filter(|run| run.evidence == evidence);
        let mut rows: Vec<_> = of_kind.flat_map(|run| run.verdicts.iter().map(move |v| (run, v))).collect();
        rows.sort_by(|(_, a), (_, b)| b.error_share().total_cmp(&a.error_share()));
        Group { evidence, rows }
    };
    Evidence::ALL.into_iter().map(group).filter(|group| !group.rows.is_empty()).collect()
}

impl Group<'_> {
    /// Returns the heading.
    pub fn title(&self) -> &'static str {
        match self.evidence {
            Evidence::Exact => "Exact solutions",
            Evidence::Measured => "Measurements and published computations",
            Evidence::KitchenBand => "Kitchen bands",
            Evidence::Information => "Information",
        }
    }

    /// Returns what the expected values are.
    pub fn description(&self) -> &'static str {
        match self.evidence {
            Evidence::Exact => "closed-form and series solutions, identities",
            Evidence::Measured => "numbers that the named source measured or computed",
            Evidence::KitchenBand => "ranges on which kitchen practice or several sources agree",
            Evidence::Information => "values for comparison, as cooks' tables",
        }
    }

    /// Returns the summary in one line.
    pub fn summary_line(&self) -> String {
        let (held, worst) = (self.held(), self.worst());
        match held.zip(worst) {
            None => format!("{} values, which pass or fail nothing", self.rows.len()),
            Some((held, worst)) => format!(
                "{held} of {} values hold{}; the largest error is {:.2} of its tolerance ({}, {})",
                self.rows.len(),
                known(self.known_misses()),
                worst.error_over_tolerance,
                worst.name,
                worst.quantity
            ),
        }
    }

    /// Returns the summary for `--json`.
    pub fn summary(&self) -> GroupSummary {
        GroupSummary {
            evidence: self.evidence,
            values: self.rows.len(),
            hold: self.held(),
            known_misses: self.known_misses(),
            worst: self.worst(),
        }
    }

    /// Returns the number of values that hold; none for information.
    fn held(&self) -> Option<usize> {
        self.rows.iter().map(|(_, v)| v.pass.map(usize::from)).sum()
    }

    fn known_misses(&self) -> usize {
        self.rows.iter().filter(|(_, v)| v.misses_as_known()).count()
    }

    fn worst(&self) -> Option<Worst> {
        let (_, v) = self.rows.first().filter(|(_, v)| v.pass.is_some())?;
        let error_over_tolerance = v.error_share();
        Some(Worst { name: v.name.clone(), quantity: v.quantity.clone(), error_over_tolerance })
    }
}

/// Returns the number of known misses as an addition to a sentence; nothing if there are none.
pub fn known(misses: usize) -> String {
    match misses {
        0 => String::new(),
        1 => ", 1 is a known miss".into(),
        n => format!(", {n} are known misses"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn run(evidence: Evidence, errors: &[Option<f64>]) -> CaseRun {
        let verdict = |error: &Option<f64>| Verdict {
            name: "case".into(),
            source: "source".into(),
            evidence: Some(evidence),
            quantity: format!("{error:?}"),
            unit: "°C".into(),
            expected: 0.0,
            tolerance: 2.0,
            got: *error,
            error: *error,
            pass: evidence.judge(error.is_some_and(|e| e.abs() <= 2.0)),
            known_miss: None,
        };
        CaseRun { id: "case".into(), lab: None, evidence, verdicts: errors.iter().map(verdict).collect() }
    }

    #[test]
    fn every_kind_has_its_own_group_with_the_largest_error_first() {
        let runs = [
            run(Evidence::Information, &[Some(9.0)]),
            run(Evidence::Exact, &[Some(0.1), Some(-1.5)]),
            run(Evidence::KitchenBand, &[Some(-3.0), None, Some(0.0)]),
            run(Evidence::Exact, &[Some(0.5)]),
        ];
        let groups = groups(&runs);
        let kinds: Vec<Evidence> = groups.iter().map(|g| g.evidence).collect();
        assert_eq!(kinds, [Evidence::Exact, Evidence::KitchenBand, Evidence::Information]);
        let errors = |g: &Group| g.rows.iter().map(|(_, v)| v.error).collect::<Vec<_>>();
        assert_eq!(errors(&groups[0]), [Some(-1.5), Some(0.5), Some(0.1)]);
        assert_eq!(errors(&groups[1]), [None, Some(-3.0), Some(0.0)]);
        assert!(groups[0].summary_line().starts_with("3 of 3 values hold; the largest error is 0.75"));
        assert!(groups[1].summary_line().starts_with("1 of 3 values hold"));
        assert_eq!(groups[2].summary_line(), "1 values, which pass or fail nothing");
    }

    #[test]
    fn a_known_miss_is_counted_and_one_that_holds_falls_short() {
        let mut missed = run(Evidence::Measured, &[Some(-3.0), Some(1.0)]);
        missed.verdicts[0].known_miss = Some("the model is too cold there".into());
        assert!(!missed.verdicts.iter().any(Verdict::falls_short));
        let runs = [missed];
        assert!(groups(&runs)[0].summary_line().starts_with("1 of 2 values hold, 1 is a known miss; the largest"));
        let mut held = run(Evidence::Measured, &[Some(1.0)]);
        held.verdicts[0].known_miss = Some("mended since".into());
        assert!(held.verdicts[0].falls_short());
    }
}

//! Pictures of the validation: curves with expected values, and all errors over their tolerances.

use saute_lab::{Case, LabReport, Subject};

use super::groups::groups;
use super::{CaseRun, timed};
use crate::chart::axis::Panel;
use crate::chart::curve_chart::{Curve, CurveChart};
use crate::chart::picture::{COLOURS, EDGES, SIZE, picture};
use crate::chart::points;
use crate::chart::scale::Scale;

/// Number of points of a curve (chosen: one for every other pixel).
const POINTS: usize = 240;
/// Runs a case with its probes read at many times.
pub fn dense(case: &Case) -> LabReport {
    let outputs = (1..=POINTS).map(|i| case.duration * i as f64 / POINTS as f64).collect();
    timed(&Case { outputs, compare: None, ..case.clone() })
}

/// Returns the expected temperatures: probe, time [s], value [°C].
pub fn expected(case: &Case) -> Vec<(&str, f64, f64)> {
    let point = |e: &'_ saute_lab::Expectation| match &e.subject {
        Subject::Probe(quantity, name, time) if quantity.is_temperature() => {
            // The name is borrowed from the case.
            case.probes.iter().map(|p| p.name.as_str()).find(|n| n == name).map(|n| (n, *time, e.value))
        }
        _ => None,
    };
    case.expectations.iter().filter_map(point).collect()
}

/// Draws the curves of a case with its expected values; none for a case with fewer than two expected temperatures.
pub fn curves(run: &CaseRun) -> Option<String> {
    let case = run.lab.as_ref()?;
    let points = expected(case);
    if points.len() < 2 {
        return None;
    }
    let report = dense(case);
    let curve = |(colour, (name, series)): (usize, (&String, &Vec<[f64; 2]>))| Curve {
        name: name.clone(),
        series: series.clone(),
        dashed: false,
        colour,
    };
    let curves: Vec<Curve> = report.probes.iter().enumerate().map(curve).collect();
    Some(draw(&case.name, curves, &points))
}

/// Draws temperatures against time, with rings at expected values.
pub fn draw(title: &str, curves: Vec<Curve>, points: &[(&str, f64, f64)]) -> String {
    let rings = points.iter().map(|(_, time, value)| [*time, *value]).collect();
    CurveChart { title, axes: ["time [s]", "°C"], from: 0.0, curves, rings, ranges: Vec::new() }.svg()
}

/// Draws every error over its tolerance in the order of the tables; values between the dashed lines hold.
pub fn errors(runs: &[CaseRun]) -> String {
    let groups = groups(runs);
    let shares: Vec<f64> = groups
        .iter()
        .flat_map(|group| &group.rows)
        .filter(|(_, v)| v.pass.is_some())
        .filter_map(|(_, v)| Some(v.error? / v.tolerance.max(f64::MIN_POSITIVE)))
        .collect();
    let [left, _, top, bottom] = EDGES;
    let right = SIZE[0] - 16.0;
    let panel = Panel {
        x: Scale::new([0.0, shares.len() as f64], [left, right]),
        y: Scale::new([-2.0, 2.0], [bottom, top]),
        edges: [left, right, top, bottom],
    };
    let mut svg = panel.y_axis([-2.0, 2.0], 1.0, "error over tolerance");
    [-1.0, 1.0].into_iter().for_each(|bound| svg += &panel.bound(bound));
    for (i, share) in shares.iter().enumerate() {
        let colour = if share.abs() <= 1.0 { COLOURS[0] } else { COLOURS[1] };
        svg += &points::dot(colour, [panel.x.at(i as f64 + 0.5), panel.y.at(share.clamp(-2.0, 2.0))]);
    }
    picture("Every expected value: error over tolerance, in the order of the tables", &svg)
}

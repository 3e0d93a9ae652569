//! Pictures of the validation: curves with expected values, and all errors over their tolerances.

use std::fmt::Write;

use saute_lab::{Case, LabReport, Subject};

use super::groups::groups;
use super::{CaseRun, timed};
use crate::report::plot::{Panel, Scale, escaped, nice_range, nice_step};

/// Size of a picture [px].
const SIZE: [f64; 2] = [720.0, 400.0];
/// Edges of the panel: left, right, top, bottom [px].
const EDGES: [f64; 4] = [52.0, 470.0, 46.0, 350.0];
/// Number of points of a curve (chosen: one for every other pixel).
const POINTS: usize = 240;
/// Colours of curves that colour-blind readers can distinguish (source: Okabe & Ito 2008 `[@okabe-ito-2008]`).
const COLOURS: [&str; 6] = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"];
/// Style sheet of a picture.
const STYLE: &str = "text{font:12px sans-serif;fill:#222}.grid{stroke:#ddd;fill:none}.curve{fill:none;stroke-width:1.6}\
     .title{font-weight:bold}.bound{stroke:#999;stroke-dasharray:4 3;fill:none}";

/// A named curve.
pub struct Curve {
    /// Name in the legend.
    pub name: String,
    /// Time [s] and temperature [°C].
    pub series: Vec<[f64; 2]>,
    /// True for a dashed line.
    pub dashed: bool,
    /// Index of the colour.
    pub colour: usize,
}

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
    Some(draw(&case.name, &curves, &points))
}

/// Draws curves against time, with rings at expected values.
pub fn draw(title: &str, curves: &[Curve], points: &[(&str, f64, f64)]) -> String {
    let values = || curves.iter().flat_map(|c| c.series.iter().copied()).chain(points.iter().map(|p| [p.1, p.2]));
    let end = values().map(|v| v[0]).fold(0.0, f64::max);
    let (low, high) = values().fold((f64::MAX, f64::MIN), |(l, h), v| (l.min(v[1]), h.max(v[1])));
    let (range, step) = nice_range(low, high, 6.0);
    let [left, right, top, bottom] = EDGES;
    let panel = Panel { x: Scale::new([0.0, end], [left, right]), y: Scale::new(range, [bottom, top]), edges: EDGES };
    let mut svg = panel.y_axis(range, step, "°C") + &panel.x_axis(end, nice_step(end, 6.0), 1.0, "time [s]");
    for (row, curve) in curves.iter().enumerate() {
        svg += &curve_with_legend(&panel, curve, top + 18.0 * row as f64);
    }
    for (_, time, value) in points {
        let (x, y) = (panel.x.at(*time), panel.y.at(*value));
        let _ = write!(svg, "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"4\" fill=\"none\" stroke=\"#222\"/>");
    }
    let y = top + 18.0 * curves.len() as f64;
    let _ = write!(
        svg,
        "<circle cx=\"{:.0}\" cy=\"{y:.0}\" r=\"4\" fill=\"none\" stroke=\"#222\"/><text x=\"{:.0}\" y=\"{:.0}\">expected</text>",
        right + 24.0,
        right + 42.0,
        y + 4.0
    );
    page(title, &svg)
}

/// Draws a curve and its entry in the legend at the height `y` [px].
fn curve_with_legend(panel: &Panel, curve: &Curve, y: f64) -> String {
    let colour = COLOURS[curve.colour % COLOURS.len()];
    let dashes = if curve.dashed { " stroke-dasharray=\"6 4\"" } else { "" };
    let path = panel.curve("", curve.series.iter().map(|p| (p[0], p[1])));
    let right = EDGES[1];
    format!(
        "<g stroke=\"{colour}\"{dashes}>{path}<path class=\"curve\" d=\"M{:.0} {y:.0}h24\"/></g><text x=\"{:.0}\" y=\"{:.0}\">{}</text>",
        right + 12.0,
        right + 42.0,
        y + 4.0,
        escaped(&curve.name)
    )
}

fn page(title: &str, inside: &str) -> String {
    let [width, height] = SIZE;
    let title = escaped(title);
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" height=\"{height}\" role=\"img\" \
         aria-label=\"{title}\"><style>{STYLE}</style><rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\
         <text class=\"title\" x=\"16\" y=\"20\">{title}</text>{inside}</svg>\n"
    )
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
    for bound in [-1.0, 1.0] {
        let _ = write!(svg, "<path class=\"bound\" d=\"M{left:.0} {:.1}H{right:.0}\"/>", panel.y.at(bound));
    }
    for (i, share) in shares.iter().enumerate() {
        let colour = if share.abs() <= 1.0 { COLOURS[0] } else { COLOURS[1] };
        let (x, y) = (panel.x.at(i as f64 + 0.5), panel.y.at(share.clamp(-2.0, 2.0)));
        let _ = write!(svg, "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"2.5\" fill=\"{colour}\"/>");
    }
    page("Every expected value: error over tolerance, in the order of the tables", &svg)
}

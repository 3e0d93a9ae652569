//! Segments compared with shape functions on the cases of the lab.

use std::fmt::Write;

use saute_kitchen::heat::Rule;
use saute_lab::{Case, Shape, Verdict, verdicts};

use super::picture::{dense, draw, expected};
use super::verdict_text::number;
use super::{CaseRun, timed};
use crate::chart::curve_chart::Curve;
use crate::workers::map_all;

/// Cases with more nodes are left out: segments are summed edge by edge (chosen: some seconds per case).
const MOST_NODES: usize = 40_000;
/// Number of pictures (chosen: the cases with the largest errors of the segments).
const PICTURES: usize = 3;

/// A case under both rules.
struct Pair<'a> {
    run: &'a CaseRun,
    case: Case,
    segments: Vec<Verdict>,
    /// Verdicts of segments on a mesh without grading.
    even: Vec<Verdict>,
}

impl Pair<'_> {
    /// Returns the largest error of the segments over its tolerance [-].
    fn worst(&self) -> f64 {
        let shares = self.segments.iter().map(|v| v.error.map_or(f64::INFINITY, |e| e.abs() / v.tolerance));
        shares.fold(0.0, f64::max)
    }
}

/// Returns the page and its pictures by name.
pub fn page(runs: &[CaseRun]) -> (String, Vec<(String, String)>) {
    let mut pairs: Vec<Pair> = map_all(runs, |_, run| pair(run)).into_iter().flatten().collect();
    let mut text = String::from(INTRODUCTION);
    pairs.iter().for_each(|pair| rows(&mut text, pair));
    let held = |of: fn(&Pair) -> usize| pairs.iter().map(of).sum::<usize>();
    let _ = writeln!(
        text,
        "\nOf {} values {} hold under the shape functions, {} under the segments on the same mesh, and {} under the segments \
         on an even mesh.",
        held(|p| p.segments.len()),
        held(|p| holding(&p.run.verdicts)),
        held(|p| holding(&p.segments)),
        held(|p| holding(&p.even))
    );
    pairs.retain(|p| expected(&p.case).len() >= 2);
    pairs.sort_by(|a, b| b.worst().total_cmp(&a.worst()));
    let pictures: Vec<(String, String)> = pairs.iter().take(PICTURES).map(picture).collect();
    for (name, _) in &pictures {
        let _ = writeln!(text, "\n![{name}](validation/{name}.svg)");
    }
    (text, pictures)
}

/// Adds a row for each value of a case.
fn rows(text: &mut String, pair: &Pair) {
    for ((shape, segment), even) in pair.run.verdicts.iter().zip(&pair.segments).zip(&pair.even) {
        let _ = writeln!(
            text,
            "| {} | {} [{}] | {:.4} | {:.4} | {} | {} | {} |",
            shape.name,
            shape.quantity,
            shape.unit,
            shape.expected,
            shape.tolerance,
            number(shape.error),
            number(segment.error),
            number(even.error)
        );
    }
}

const INTRODUCTION: &str = "# What the shape functions gain\n\n\
    Written by `saute validate --write`. Earlier work models each mesh edge as a rod: conductance k · V^(2/3) / \
    length, where V is the mean of both nodes' shares of the volume; capacity ρ c V; heat enters at the vertices \
    within a given distance of the pan (here zero: the nodes on the face, each with its share of the face). \
    Linear shape functions use the area over length of the cells that share the edge.\n\n\
    Rods are accurate only inside a lattice of cubes. At a face the cells are halved, and the rods along the \
    face and into it conduct too much; where the mesh is graded towards a face, the rods across its flat cells \
    conduct too little. Refining the mesh does not help while the cells keep their proportions.\n\n\
    The table compares both rules on the lab's slabs and boxes. A slab counts as a column as wide as its mean \
    spacing. The last column is the most favourable case for the segments: a mesh without grading.\n\n\
    | case | quantity | expected | tolerance | error, shape functions | error, segments | error, segments, even mesh |\n\
    |---|---|---:|---:|---:|---:|---:|\n";

fn holding(verdicts: &[Verdict]) -> usize {
    verdicts.iter().filter(|v| v.pass == Some(true)).count()
}

/// Runs a case with segments; none if the rule does not apply or the case is large.
fn pair(run: &CaseRun) -> Option<Pair<'_>> {
    let lab = run.lab.as_ref().filter(|c| c.rule == Rule::ShapeFunctions && c.bodies.len() == 1)?;
    let plain = matches!(lab.shape, Shape::Slab | Shape::Box)
        && lab.materials.iter().all(|m| m.constants().is_some())
        && lab.compare.is_none();
    if !plain || lab.node_count() > MOST_NODES {
        return None;
    }
    let case = Case { rule: Rule::Segments, ..lab.clone() };
    let segments = verdicts(&case, &timed(&case));
    let mut even = case.clone();
    even.bodies.iter_mut().for_each(|b| b.grading = 0.0);
    let even = verdicts(&even, &timed(&even));
    Some(Pair { run, case, segments, even })
}

fn picture(pair: &Pair) -> (String, String) {
    let mut curves = Vec::new();
    for (rule, name, dashed) in [(Rule::ShapeFunctions, "shape functions", false), (Rule::Segments, "segments", true)] {
        let report = dense(&Case { rule, ..pair.case.clone() });
        let named = report.probes.into_iter().enumerate();
        curves.extend(named.map(|(colour, (probe, series))| Curve {
            name: format!("{probe}, {name}"),
            series,
            dashed,
            colour,
        }));
    }
    (format!("segments-{}", pair.run.id), draw(&pair.case.name, curves, &expected(&pair.case)))
}

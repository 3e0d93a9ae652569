//! Learning curves as a picture: medians with their intervals by trial.

use std::fmt::Write;

use maud::{Markup, PreEscaped, html};
use saute_study::Analysis;
use saute_study::analysis::{Point, Quantity};

use super::tables;
use crate::report::plot::{Mark, Panel, Scale, marks, nice_range};

/// Widths of the picture on a desktop and on a phone [px].
const WIDTHS: [(&str, f64); 2] = [("wide", 760.0), ("narrow", 350.0)];
/// Height of the picture, and edges of its panel [px].
const HEIGHT: f64 = 320.0;
const LEFT: f64 = 44.0;
const RIGHT: f64 = 14.0;
const TOP: f64 = 46.0;
const BOTTOM: f64 = 274.0;
/// Classes of the curves in the style sheet, by condition.
const CLASSES: [&str; 4] = ["core", "top", "bottom", "mass"];
/// Distance between the points of two conditions [trials] (chosen: their intervals do not cover each other).
const APART: f64 = 0.12;

/// Returns the picture of a quantity with its legend.
pub fn figure(analysis: &Analysis, quantity: Quantity) -> Markup {
    let conditions = analysis.conditions();
    html! {
        figure.plot {
            ul.legend {
                @for (place, condition) in conditions.iter().enumerate() {
                    li {
                        svg viewBox="0 0 28 8" aria-hidden="true" { path class={ "curve " (class(place)) } d="M1 4H27" {} }
                        "condition " (condition)
                    }
                }
            }
            @for (name, width) in WIDTHS { (drawing(analysis, quantity, &conditions, (name, width))) }
            figcaption { "Points are medians, bars their 90 % bootstrap intervals." }
        }
    }
}

fn class(place: usize) -> &'static str {
    CLASSES[place % CLASSES.len()]
}

fn drawing(analysis: &Analysis, quantity: Quantity, conditions: &[String], (name, width): (&str, f64)) -> Markup {
    let points: Vec<&Point> = analysis.curves.iter().filter(|point| point.quantity == quantity).collect();
    let most = points.iter().map(|point| point.number).max().unwrap_or(1);
    let ends = points.iter().filter_map(|point| point.interval).flat_map(|i| [i.low, i.high]);
    let (low, high) = ends.fold((0.0_f64, 10.0_f64), |(l, h), v| (l.min(v), h.max(v)));
    let (range, step) = nice_range(low, high, 6.0);
    let x = Scale::new([0.5, f64::from(most) + 0.5], [LEFT, width - RIGHT]);
    let panel = Panel { x, y: Scale::new(range, [BOTTOM, TOP]), edges: [LEFT, width - RIGHT, TOP, BOTTOM] };
    let real = analysis.real_after.iter().map(|after| Mark {
        time_s: f64::from(*after) + 0.5,
        name: "cooked for real".to_owned(),
        tooltip: format!("cooked at a real stove after trial {after}"),
    });
    let mut svg = marks(x, width, [TOP - 16.0, BOTTOM], &real.collect::<Vec<_>>());
    svg += &panel.y_axis(range, step, tables::quantity(quantity));
    svg += &panel.x_axis([1.0, f64::from(most)], 1.0, 1.0, "trial");
    for (place, condition) in conditions.iter().enumerate() {
        let own: Vec<&Point> = points.iter().filter(|point| point.condition == *condition).copied().collect();
        svg += &curve(&panel, &own, place, conditions.len());
    }
    let label = format!("{} by trial and condition", tables::quantity(quantity));
    html! {
        svg class=(name) viewBox={ "0 0 " (width) " " (HEIGHT) } role="img" aria-label=(label) { (PreEscaped(svg)) }
    }
}

/// A curve with the bars of its intervals.
fn curve(panel: &Panel, points: &[&Point], place: usize, count: usize) -> String {
    let aside = APART * (place as f64 - (count as f64 - 1.0) / 2.0);
    let at = |point: &Point| f64::from(point.number) + aside;
    let known = points.iter().filter_map(|point| Some((at(point), point.interval?)));
    let mut svg = panel.curve(class(place), known.clone().map(|(x, interval)| (x, interval.median)));
    for (x, interval) in known {
        svg += &panel.curve(class(place), [(x, interval.low), (x, interval.high)].into_iter());
        let (x, y) = (panel.x.at(x), panel.y.at(interval.median));
        // Writing to a string cannot fail.
        let _ = write!(svg, "<circle class=\"curve {}\" cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"3\"/>", class(place));
    }
    svg
}

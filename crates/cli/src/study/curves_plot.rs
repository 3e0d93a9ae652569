//! Learning curves as a picture: medians with their intervals by trial.

use maud::Markup;
use saute_study::Analysis;
use saute_study::analysis::{Point, Quantity};

use super::tables;
use crate::chart::axis::{Panel, Ticks};
use crate::chart::figure::Figure;
use crate::chart::moments::{Moment, moments};
use crate::chart::points;
use crate::chart::scale::{Scale, nice_range};

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
    let entry = |(place, condition): (usize, &String)| (class(place), format!("condition {condition}"));
    let legend: Vec<(&str, String)> = conditions.iter().enumerate().map(entry).collect();
    let label = format!("{} by trial and condition", tables::quantity(quantity));
    let figure = Figure { legend: &legend, label: &label, title: None, height: HEIGHT };
    let caption = "Points are medians, bars their 90 % bootstrap intervals.";
    figure.markup(|width| drawing(analysis, quantity, &conditions, width), Some(caption))
}

fn class(place: usize) -> &'static str {
    CLASSES[place % CLASSES.len()]
}

fn drawing(analysis: &Analysis, quantity: Quantity, conditions: &[String], width: f64) -> String {
    let points: Vec<&Point> = analysis.curves.iter().filter(|point| point.quantity == quantity).collect();
    let most = points.iter().map(|point| point.number).max().unwrap_or(1);
    let ends = points.iter().filter_map(|point| point.interval).flat_map(|i| [i.low, i.high]);
    let (low, high) = ends.fold((0.0_f64, 10.0_f64), |(l, h), v| (l.min(v), h.max(v)));
    let (range, step) = nice_range(low, high, 6.0);
    let x = Scale::new([0.5, f64::from(most) + 0.5], [LEFT, width - RIGHT]);
    let panel = Panel { x, y: Scale::new(range, [BOTTOM, TOP]), edges: [LEFT, width - RIGHT, TOP, BOTTOM] };
    let real = analysis.real_after.iter().map(|after| Moment {
        at: f64::from(*after) + 0.5,
        name: "cooked for real".to_owned(),
        tooltip: format!("cooked at a real stove after trial {after}"),
    });
    let mut svg = moments(x, width, [TOP - 16.0, BOTTOM], &real.collect::<Vec<_>>());
    svg += &panel.y_axis(range, step, tables::quantity(quantity));
    svg += &panel.x_axis(Ticks { range: [1.0, f64::from(most)], step: 1.0 }, |trial| trial.to_string(), "trial");
    for (place, condition) in conditions.iter().enumerate() {
        let own: Vec<&Point> = points.iter().filter(|point| point.condition == *condition).copied().collect();
        svg += &curve(&panel, &own, place, conditions.len());
    }
    svg
}

/// A curve with the bars of its intervals.
fn curve(panel: &Panel, points: &[&Point], place: usize, count: usize) -> String {
    let aside = APART * (place as f64 - (count as f64 - 1.0) / 2.0);
    let at = |point: &Point| f64::from(point.number) + aside;
    let known = points.iter().filter_map(|point| Some((at(point), point.interval?)));
    let mut svg = panel.curve(class(place), known.clone().map(|(x, interval)| (x, interval.median)));
    for (x, interval) in known {
        svg += &panel.curve(class(place), [(x, interval.low), (x, interval.high)].into_iter());
        svg += &points::on_curve(class(place), [panel.x.at(x), panel.y.at(interval.median)]);
    }
    svg
}

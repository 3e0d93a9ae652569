//! What a number depends on as a picture: a bar for each value.

use std::fmt::Write;

use maud::{Markup, PreEscaped, html};
use saute_sweep::Manifest;

use super::{Found, Sensitivity, tables};
use crate::report::plot::{Panel, Scale, escaped};

/// Widths of the picture on a desktop and on a phone [px].
const WIDTHS: [(&str, f64); 2] = [("wide", 760.0), ("narrow", 350.0)];
/// Edges of the bars [px].
const LEFT: f64 = 8.0;
const RIGHT: f64 = 16.0;
const TOP: f64 = 8.0;
/// Height of a value with its name and bars, and room below all for the axis [px].
const ROW: f64 = 46.0;
const AXIS: f64 = 40.0;

/// Returns the picture of a number.
pub fn figure(manifest: &Manifest, one: &Sensitivity) -> Markup {
    html! {
        figure.plot {
            ul.legend {
                @for (class, name) in legend(&one.found) {
                    li { svg viewBox="0 0 28 8" aria-hidden="true" { path class={ "curve " (class) } d="M1 4H27" {} } (name) }
                }
            }
            @for (name, width) in WIDTHS { (drawing(manifest, one, name, width)) }
        }
    }
}

fn legend(found: &Found) -> [(&'static str, &'static str); 2] {
    match found {
        Found::Sobol(_) => [("core", "alone"), ("top", "with others; thin: 90 % interval")],
        Found::Effects(_) => [("core", "mean size of the effects"), ("top", "their deviation")],
    }
}

/// Returns the two bars of a value as value, low and high, in the unit of the axis.
fn bars(found: &Found, place: usize) -> [[f64; 3]; 2] {
    match found {
        Found::Sobol(indices) => {
            [indices.of[place].first, indices.of[place].total].map(|e| [e.value, e.low, e.high].map(|v| 100.0 * v))
        }
        Found::Effects(effects) => {
            let of = effects.of[place];
            [of.mean_size, of.deviation].map(|v| [v; 3])
        }
    }
}

fn drawing(manifest: &Manifest, one: &Sensitivity, name: &str, width: f64) -> Markup {
    let count = manifest.varied.len();
    let bottom = TOP + ROW * count as f64;
    let all = (0..count).flat_map(|place| bars(&one.found, place)).flatten();
    let most = all.fold(f64::MIN_POSITIVE, f64::max);
    let end = if matches!(one.found, Found::Sobol(_)) { most.max(100.0) } else { most };
    let x = Scale::new([0.0, end], [LEFT, width - RIGHT]);
    let panel = Panel { x, y: Scale::new([0.0, 1.0], [0.0, 1.0]), edges: [LEFT, width - RIGHT, TOP, bottom] };
    let mut svg = String::new();
    for (place, path) in manifest.varied.iter().enumerate() {
        svg += &value(&panel, path, bars(&one.found, place), TOP + ROW * place as f64);
    }
    svg += &match one.found {
        Found::Sobol(_) => panel.x_axis([0.0, end], 20.0, 1.0, "share of the variance [%]"),
        Found::Effects(_) => {
            panel.x_axis([0.0, end], end, 1.0, "").replace(&format!(">{end}<"), &format!(">{end:.3}<"))
        }
    };
    let label = format!("What {} depends on", one.heading.name);
    let height = bottom + AXIS;
    html! {
        svg class=(name) viewBox={ "0 0 " (width) " " (height) } role="img" aria-label=(label) {
            title { (label) ": " @for (place, path) in manifest.varied.iter().enumerate() { (path) " " (tables::words(one, place)) ". " } }
            (PreEscaped(svg))
        }
    }
}

/// Name and bars of one value.
fn value(panel: &Panel, path: &str, bars: [[f64; 3]; 2], top: f64) -> String {
    let mut svg = format!("<text class=\"quantity\" x=\"{LEFT}\" y=\"{:.1}\">{}</text>", top + 12.0, escaped(path));
    for ((class, [value, low, high]), y) in ["core", "top"].into_iter().zip(bars).zip([top + 21.0, top + 33.0]) {
        let [from, to] = [0.0, value.max(0.0)].map(|v| panel.x.at(v));
        // Writing to a string cannot fail.
        let _ = write!(
            svg,
            "<path class=\"curve {class}\" style=\"stroke-width:8;stroke-linecap:butt\" d=\"M{from:.1} {y:.1}H{to:.1}\"/>"
        );
        if high > low {
            let [from, to] = [low.max(0.0), high.max(0.0)].map(|v| panel.x.at(v));
            let _ = write!(svg, "<path class=\"hob\" d=\"M{from:.1} {y:.1}H{to:.1}\"/>");
        }
    }
    svg
}

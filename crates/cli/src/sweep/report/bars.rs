//! What a number depends on as a picture: a bar for each value.

use maud::Markup;
use saute_sweep::Manifest;

use super::{Indices, Sensitivity, tables};
use crate::chart::axis::{Panel, Ticks, quantity};
use crate::chart::bars::{bar, interval};
use crate::chart::figure::Figure;
use crate::chart::scale::Scale;

/// Edges of the bars [px].
const LEFT: f64 = 8.0;
const RIGHT: f64 = 16.0;
const TOP: f64 = 8.0;
/// Height of a value with its name and bars, and room below all for the axis [px].
const ROW: f64 = 46.0;
const AXIS: f64 = 40.0;

/// Returns the picture of a number.
pub fn figure(manifest: &Manifest, one: &Sensitivity) -> Markup {
    let label = format!("What {} depends on", one.heading.name);
    let values = manifest.varied.iter().enumerate();
    let title = values.map(|(place, path)| format!("{path} {}. ", tables::words(one, place))).collect::<String>();
    let figure = Figure {
        legend: &legend(&one.found),
        label: &label,
        title: Some(format!("{label}: {title}")),
        height: bottom(manifest) + AXIS,
    };
    figure.markup(|width| drawing(manifest, one, width), None)
}

fn legend(found: &Indices) -> [(&'static str, String); 2] {
    let entries = match found {
        Indices::Sobol(_) => [("core", "alone"), ("top", "with others; thin: 90 % interval")],
        Indices::Effects(_) => [("core", "mean size of the effects"), ("top", "their deviation")],
    };
    entries.map(|(class, name)| (class, name.to_owned()))
}

/// Returns where the bars end [px].
fn bottom(manifest: &Manifest) -> f64 {
    TOP + ROW * manifest.varied.len() as f64
}

/// Returns the two bars of a value as value, low and high, in the unit of the axis.
fn bars(found: &Indices, place: usize) -> [[f64; 3]; 2] {
    match found {
        Indices::Sobol(indices) => {
            [indices.of[place].first, indices.of[place].total].map(|e| [e.value, e.low, e.high].map(|v| 100.0 * v))
        }
        Indices::Effects(effects) => {
            let of = effects.of[place];
            [of.mean_size, of.deviation].map(|v| [v; 3])
        }
    }
}

fn drawing(manifest: &Manifest, one: &Sensitivity, width: f64) -> String {
    let count = manifest.varied.len();
    let all = (0..count).flat_map(|place| bars(&one.found, place)).flatten();
    let most = all.fold(f64::MIN_POSITIVE, f64::max);
    let end = if matches!(one.found, Indices::Sobol(_)) { most.max(100.0) } else { most };
    let edges = [LEFT, width - RIGHT, TOP, bottom(manifest)];
    let (x, y) = (Scale::new([0.0, end], [edges[0], edges[1]]), Scale::new([0.0, count as f64], [edges[2], edges[3]]));
    let values = manifest.varied.iter().enumerate();
    let values = values.map(|(place, path)| value(x, path, bars(&one.found, place), y.at(place as f64)));
    values.collect::<String>() + &axis(&Panel { x, y, edges }, &one.found, end)
}

fn axis(panel: &Panel, found: &Indices, end: f64) -> String {
    let range = [0.0, end];
    match found {
        Indices::Sobol(_) => {
            panel.x_axis(Ticks { range, step: 20.0 }, |share| share.to_string(), "share of the variance [%]")
        }
        Indices::Effects(_) => {
            let word = |effect| if effect == 0.0 { "0".to_owned() } else { format!("{effect:.3}") };
            panel.x_axis(Ticks { range, step: end }, word, "")
        }
    }
}

/// Name and bars of one value.
fn value(x: Scale, path: &str, bars: [[f64; 3]; 2], top: f64) -> String {
    let places = ["core", "top"].into_iter().zip([top + 21.0, top + 33.0]);
    let drawn = places.zip(bars).map(|((class, y), [value, low, high])| {
        // An interval is drawn over its bar.
        bar(x, class, value, y) + &interval(x, [low, high], y)
    });
    quantity([LEFT, top + 12.0], path) + &drawn.collect::<String>()
}

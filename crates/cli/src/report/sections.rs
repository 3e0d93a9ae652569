//! The cross-sections step by step.

use saute_app::TemperatureMap;
use saute_recipe::step_record::StepRecord;
use saute_recipe::{Cook, Summary};

use super::markup::{data_uri, escaped};
use crate::section_files::Snapshot;
use crate::wording::{self, duration};

/// Pictures of every moment at which something was done.
pub fn section(cook: &Cook, summary: &Summary, snapshots: &[Snapshot]) -> String {
    if snapshots.is_empty() {
        return String::new();
    }
    let first_of_moment =
        |(i, s): &(usize, &Snapshot)| !snapshots[..*i].iter().any(|e| e.time_s == s.time_s && e.food == s.food);
    let figures: String =
        snapshots.iter().enumerate().filter(first_of_moment).filter_map(|(_, s)| figure(cook, summary, s)).collect();
    let pictured = |p: &&saute_kitchen::Piece| snapshots.iter().any(|s| s.food == p.id);
    let sizes: Vec<String> = cook.kitchen.pieces().iter().filter(pictured).map(size).collect();
    format!(
        "<section><h2>Cross-sections</h2><p>Through the centre, across the longest side, as the food lies ({}). Above: as the eye sees it; \
         below: temperature.</p>{}<div class=\"sections\">{figures}</div></section>",
        sizes.join("; "),
        legend()
    )
}

fn size(piece: &saute_kitchen::Piece) -> String {
    let across = piece.model.size()[0].min(piece.model.size()[1]);
    format!("{} {:.0} × {:.0} mm", escaped(&piece.id), across * 1e3, piece.model.size()[2] * 1e3)
}

/// A moment; none if nothing was done to this food then.
fn figure(cook: &Cook, summary: &Summary, snapshot: &Snapshot) -> Option<String> {
    let concerns =
        |s: &&StepRecord| s.time_s == snapshot.time_s && (s.target.is_none() || s.foods.contains(&snapshot.food));
    let done: Vec<String> = summary.steps.iter().filter(concerns).map(wording::step).collect();
    if done.is_empty() {
        return None;
    }
    let [look, temperature] = snapshot.small.each_ref().map(|png| data_uri(png));
    let (time, done) = (duration(snapshot.time_s), escaped(&done.join(", ")));
    let readings = readings(cook, snapshot).map_or(String::new(), |[core, top, bottom, _]| {
        format!("<br>core {core:.0}, top {top:.0}, bottom {bottom:.0}\u{a0}°C")
    });
    let alt = format!("Cross-section of {} after {time}", escaped(&snapshot.food));
    let name = if snapshot.of_several { format!("{}: ", escaped(&snapshot.food)) } else { String::new() };
    Some(format!(
        "<figure><img src=\"{look}\" alt=\"{alt}\"><img src=\"{temperature}\" alt=\"{alt}, temperature\">\
         <figcaption><b>{time}</b> {name}{done}{readings}</figcaption></figure>"
    ))
}

/// Core, top, bottom [°C] and mass [g] of the food at that moment, as the series has them.
fn readings(cook: &Cook, snapshot: &Snapshot) -> Option<[f64; 4]> {
    let food = cook.kitchen.pieces().iter().position(|p| p.id == snapshot.food)?;
    Some(super::row_at(cook, snapshot.time_s)?.foods[food])
}

/// The colours of the temperatures.
fn legend() -> String {
    let map = TemperatureMap::Uniform.map();
    let stops: Vec<String> = map.table.iter().step_by(15).map(|[r, g, b]| format!("rgb({r} {g} {b})")).collect();
    let ticks: String = (0..=4)
        .map(|i| map.from + (map.to - map.from) * f64::from(i) / 4.0)
        .map(|c| format!("<span>{c:.0} °C</span>"))
        .collect();
    format!(
        "<div class=\"scale\"><div style=\"background:linear-gradient(to right,{})\"></div><p>{ticks}</p></div>",
        stops.join(",")
    )
}

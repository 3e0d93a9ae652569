//! The cross-sections step by step.

use data_encoding::BASE64;
use maud::{Markup, html};
use saute_kitchen::Piece;
use saute_picture::TemperatureMap;
use saute_recipe::step_record::StepRecord;
use saute_recipe::{Cook, Summary};

use crate::output::section_files::Snapshot;
use crate::wording::{self, duration};

/// Returns the pictures of every moment at which a step was carried out; nothing if there are none.
pub fn section(cook: &Cook, summary: &Summary, snapshots: &[Snapshot]) -> Markup {
    let is_first_of_moment =
        |(i, s): &(usize, &Snapshot)| !snapshots[..*i].iter().any(|e| e.time_s == s.time_s && e.food == s.food);
    let moments = snapshots.iter().enumerate().filter(is_first_of_moment).map(|(_, s)| s);
    let is_pictured = |p: &&Piece| snapshots.iter().any(|s| s.food == p.id);
    let sizes: Vec<String> = cook.kitchen.pieces().iter().filter(is_pictured).map(size).collect();
    html! {
        @if !snapshots.is_empty() {
            section {
                h2 { "Cross-sections" }
                p {
                    "Through the centre, across the longest side, as the food lies (" (sizes.join("; "))
                    "). Above: as the eye sees it; below: temperature."
                }
                (legend())
                div.sections { @for snapshot in moments { (figure(cook, summary, snapshot)) } }
            }
        }
    }
}

fn size(piece: &Piece) -> String {
    let across = piece.model.size()[0].min(piece.model.size()[1]);
    format!("{} {:.0} × {:.0} mm", piece.id, across * 1e3, piece.model.size()[2] * 1e3)
}

/// Returns the pictures of a moment; nothing if no step concerned this food.
fn figure(cook: &Cook, summary: &Summary, snapshot: &Snapshot) -> Markup {
    let concerns = |s: &&StepRecord| {
        s.time_s == snapshot.time_s && (s.action.target().is_none() || s.foods.contains(&snapshot.food))
    };
    let done: Vec<String> = summary.steps.iter().filter(concerns).map(wording::step).collect();
    if done.is_empty() {
        return Markup::default();
    }
    let [look, temperature] = snapshot.small.each_ref().map(|png| data_uri(png));
    let time = duration(snapshot.time_s);
    let alt = format!("Cross-section of {} after {time}", snapshot.food);
    html! {
        figure {
            img src=(look) alt=(alt);
            img src=(temperature) alt={ (alt) ", temperature" };
            figcaption {
                b { (time) } " " @if snapshot.of_several { (snapshot.food) ": " } (done.join(", "))
                @if let Some([core, top, bottom, _]) = readings(cook, snapshot) {
                    br; (format!("core {core:.0}, top {top:.0}, bottom {bottom:.0}\u{a0}°C"))
                }
            }
        }
    }
}

/// Returns a PNG as a `data:` address.
fn data_uri(png: &[u8]) -> String {
    format!("data:image/png;base64,{}", BASE64.encode(png))
}

/// Returns core, top, bottom [°C] and mass [g] of the food at that moment, from the series.
fn readings(cook: &Cook, snapshot: &Snapshot) -> Option<[f64; 4]> {
    let food = cook.kitchen.pieces().iter().position(|p| p.id == snapshot.food)?;
    Some(super::row_at(cook, snapshot.time_s)?.foods[food])
}

/// Returns the colour scale of the temperatures.
fn legend() -> Markup {
    let map = TemperatureMap::Uniform.map();
    let stops: Vec<String> = map.table.iter().step_by(15).map(|[r, g, b]| format!("rgb({r} {g} {b})")).collect();
    let ticks = (0..=4).map(|i| map.from + (map.to - map.from) * f64::from(i) / 4.0);
    html! {
        div.scale {
            div style={ "background:linear-gradient(to right," (stops.join(",")) ")" } {}
            p { @for celsius in ticks { span { (format!("{celsius:.0} °C")) } } }
        }
    }
}

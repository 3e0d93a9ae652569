//! The four most important numbers of a food; for a group their means.

use maud::{Markup, html};
use saute_recipe::summary::FoodOrGroup;
use saute_recipe::{ActionKind, Summary};

use crate::wording::duration;

/// Returns the numbers with a heading, which a cook of a single food does not need.
pub fn section(summary: &Summary, entry: &FoodOrGroup) -> Markup {
    let food = entry.food;
    let (top, bottom) = (&food.surfaces.top, &food.surfaces.bottom);
    let lost = 100.0 * (1.0 - food.mass_g.end / food.mass_g.start);
    let entries = [
        (format!("{:.1} °C", food.core_c.peak), "core, at its highest"),
        (duration(mean_seconds_in_pan(summary, entry)), "in the pan"),
        (format!("{:.0} % · {:.0} %", bottom.browned_pct, top.browned_pct), "browned, bottom · top"),
        (format!("{lost:.1} %"), "of its weight lost"),
    ];
    html! {
        section {
            @if summary.foods.len() > 1 {
                h2 { (food.id) @if entry.group { ", means of " (entry.members.len()) } }
            }
            dl.key {
                @for (value, name) in entries { div { dd { (value) } dt { (name) } } }
            }
        }
    }
}

/// Mean time that the pieces of a food or a group lay in the pan [s].
fn mean_seconds_in_pan(summary: &Summary, entry: &FoodOrGroup) -> f64 {
    let members = &summary.foods[entry.members.clone()];
    members.iter().map(|f| seconds_in_pan(summary, &f.id)).sum::<f64>() / members.len() as f64
}

/// Time that a piece lay in the pan, summed over its stays [s].
fn seconds_in_pan(summary: &Summary, id: &str) -> f64 {
    let (mut total, mut since) = (0.0, None);
    for step in summary.steps.iter().filter(|s| s.foods.iter().any(|food| food == id)) {
        match step.action.kind() {
            ActionKind::Put => since = Some(step.time_s),
            ActionKind::Rest => total += since.take().map_or(0.0, |s| step.time_s - s),
            _ => {}
        }
    }
    total + since.map_or(0.0, |s| summary.simulated_s - s)
}

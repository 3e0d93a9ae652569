//! `report.html`: a cook on one page that needs no other file.

mod curves;
mod doneness;
mod key_numbers;
mod numbers;
mod sections;

use maud::{Markup, html};
use saute_kitchen::doneness::ScaleChoice;
use saute_recipe::recorder::Row;
use saute_recipe::summary::FoodOrGroup;
use saute_recipe::{Cook, Recipe, StoppedBy, Summary};

use crate::output::section_files::Snapshot;
use crate::page;
use crate::wording::duration;

/// Returns the page of a cook.
pub fn page(cook: &Cook, summary: &Summary, snapshots: &[Snapshot], scales: &ScaleChoice) -> String {
    let content = html! {
        (header(cook, summary))
        @for entry in summary.foods_and_groups() { (key_numbers::section(summary, &entry)) }
        (doneness::section(summary, scales))
        (curves::section(cook, summary))
        (sections::section(cook, summary, snapshots))
        (numbers::section(cook, summary))
        section { h2 { "Recipe" } pre { (cook.runner.recipe().text) } }
        footer {
            "saute " (env!("CARGO_PKG_VERSION"))
            ". A simulation: for learning, not for judging whether food is safe to eat."
        }
    };
    page::whole(&summary.title, &doneness::style(), &content)
}

fn header(cook: &Cook, summary: &Summary) -> Markup {
    let recipe = cook.runner.recipe();
    html! {
        header {
            h1 { (summary.title) }
            p {
                @for entry in summary.foods_and_groups() { (ingredient(recipe, &entry)) br; }
                "pan: " (cook.kitchen.pan_model().description.name) br;
                (duration(summary.simulated_s)) " simulated"
            }
            @if summary.stopped_by == StoppedBy::MaxS {
                p.notice {
                    "Stopped by max_s = " (recipe.max_s) " s: step " (cook.runner.waiting_step() + 1)
                    " was still waiting (" (cook.runner.waiting_for()) ")."
                }
            }
            @for warning in &summary.warnings { p.notice { (warning) } }
        }
    }
}

/// Returns one line for a food or a group as the recipe orders it: count, kind, size and temperature.
fn ingredient(recipe: &Recipe, entry: &FoodOrGroup) -> String {
    let order = &recipe.foods[entry.members.start];
    let [length, width, thickness] = order.size.map(|m| m * 1e3);
    let celsius = saute_kitchen::celsius(order.temperature);
    let count = if entry.group { format!("{} × ", entry.members.len()) } else { String::new() };
    format!("{}: {count}{}, {length:.0} × {width:.0} × {thickness:.0} mm, {celsius:.0} °C", entry.food.id, order.kind)
}

/// Returns the row of the series at a time [s]; none if the series has no row there.
fn row_at(cook: &Cook, time_s: f64) -> Option<&Row> {
    let rows = &cook.recorder.rows;
    rows.binary_search_by(|r| r.time_s.total_cmp(&time_s)).ok().map(|i| &rows[i])
}

//! `report.html`: a cook on one page that needs no other file.

mod curves;
mod doneness;
pub mod markup;
mod numbers;
pub mod plot;
mod sections;

use saute_kitchen::food::Scale;
use saute_recipe::recorder::Row;
use saute_recipe::summary::Told;
use saute_recipe::{Cook, Recipe, StoppedBy, Summary};

use self::markup::escaped;
use crate::section_files::Snapshot;
use crate::wording::duration;

const STYLE: &str = include_str!("report.css");

/// The whole page.
pub fn html(cook: &Cook, summary: &Summary, snapshots: &[Snapshot], scale: &Scale) -> String {
    let title = escaped(&summary.title);
    let parts = [
        head(cook, summary, &title),
        summary.told().iter().map(|t| key_numbers(summary, t)).collect(),
        doneness::section(summary, scale),
        curves::section(cook, summary),
        sections::section(cook, summary, snapshots),
        numbers::section(cook, summary),
        format!("<section><h2>Recipe</h2><pre>{}</pre></section>", escaped(&cook.runner.recipe().text)),
        foot(),
    ];
    format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta name=\"color-scheme\" content=\"light dark\">\n<title>{title}</title>\n<style>\n{STYLE}{}</style>\n</head>\n\
         <body>\n<main>\n{}\n</main>\n</body>\n</html>\n",
        doneness::style(),
        parts.join("\n")
    )
}

fn head(cook: &Cook, summary: &Summary, title: &str) -> String {
    let recipe = cook.runner.recipe();
    let foods: Vec<String> = summary.told().iter().map(|told| foods(recipe, told)).collect();
    let pan = escaped(&cook.kitchen.pan_model().description.name);
    let end = match summary.stopped_by {
        StoppedBy::End => String::new(),
        StoppedBy::MaxS => {
            let (step, waiting) = (cook.runner.waiting_step() + 1, escaped(&cook.runner.waiting_for()));
            format!(
                "<p class=\"notice\">Stopped by max_s = {} s: step {step} was still waiting ({waiting}).</p>",
                recipe.max_s
            )
        }
    };
    let warnings: String = summary.warnings.iter().map(|w| format!("<p class=\"notice\">{}</p>", escaped(w))).collect();
    let simulated = duration(summary.simulated_s);
    format!(
        "<header><h1>{title}</h1><p>{}<br>pan: {pan}<br>{simulated} simulated</p>{end}{warnings}</header>",
        foods.join("<br>")
    )
}

/// What was asked for, a group on one line.
fn foods(recipe: &Recipe, told: &Told) -> String {
    let order = &recipe.foods[told.members.start];
    let [length, width, thickness] = order.size.map(|m| m * 1e3);
    let celsius = saute_kitchen::celsius(order.temperature);
    let count = if told.group { format!("{} × ", told.members.len()) } else { String::new() };
    format!(
        "{}: {count}{}, {length:.0} × {width:.0} × {thickness:.0} mm, {celsius:.0} °C",
        escaped(&told.food.id),
        escaped(&order.kind)
    )
}

/// What one wants to know first; of a group the means.
fn key_numbers(summary: &Summary, told: &Told) -> String {
    let food = told.food;
    let (top, bottom) = (&food.surfaces.top, &food.surfaces.bottom);
    let lost = 100.0 * (1.0 - food.mass_g.end / food.mass_g.start);
    let entries = [
        (format!("{:.1} °C", food.core_c.peak), "core, at its highest"),
        (duration(seconds_in_pan(summary, told)), "in the pan"),
        (format!("{:.0} % · {:.0} %", bottom.browned_pct, top.browned_pct), "browned, bottom · top"),
        (format!("{lost:.1} %"), "of its weight lost"),
    ];
    let tiles: String =
        entries.iter().map(|(value, name)| format!("<div><dd>{value}</dd><dt>{name}</dt></div>")).collect();
    let means = if told.group { format!(", means of {}", told.members.len()) } else { String::new() };
    let alone = summary.foods.len() == 1;
    let heading = if alone { String::new() } else { format!("<h2>{}{means}</h2>", escaped(&food.id)) };
    format!("<section>{heading}<dl class=\"key\">{tiles}</dl></section>")
}

/// How long foods lay in the pan on average [s].
fn seconds_in_pan(summary: &Summary, told: &Told) -> f64 {
    let members = &summary.foods[told.members.clone()];
    members.iter().map(|f| seconds_of_one_in_pan(summary, &f.id)).sum::<f64>() / members.len() as f64
}

/// How long a food lay in the pan, all its stays together [s].
fn seconds_of_one_in_pan(summary: &Summary, id: &str) -> f64 {
    let (mut total, mut since) = (0.0, None);
    for step in summary.steps.iter().filter(|s| s.foods.iter().any(|food| food == id)) {
        match step.action {
            "put" => since = Some(step.time_s),
            "rest" => total += since.take().map_or(0.0, |s| step.time_s - s),
            _ => {}
        }
    }
    total + since.map_or(0.0, |s| summary.simulated_s - s)
}

/// The series' row of a moment.
fn row_at(cook: &Cook, time_s: f64) -> Option<&Row> {
    let rows = &cook.recorder.rows;
    rows.binary_search_by(|r| r.time_s.total_cmp(&time_s)).ok().map(|i| &rows[i])
}

fn foot() -> String {
    format!(
        "<footer>saute {}. A simulation: for learning, not for judging whether food is safe to eat.</footer>",
        env!("CARGO_PKG_VERSION")
    )
}

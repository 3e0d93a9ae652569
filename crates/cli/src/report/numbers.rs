//! The tables: food, pan, energy, steps.

use maud::{Markup, Render, html};
use saute_recipe::group_summary::GroupSummary;
use saute_recipe::step_record::StepRecord;
use saute_recipe::summary::{FoodOrGroup, FoodSummary, Surface};
use saute_recipe::{Cook, Summary};

use crate::page;
use crate::wording::{self, duration};

/// Returns all tables.
pub fn section(cook: &Cook, summary: &Summary) -> Markup {
    html! {
        section {
            h2 { "Numbers" }
            div.tables {
                @for entry in summary.foods_and_groups() { (food(&entry)) }
                (pan(summary))
                (energy(summary))
            }
            @for group in &summary.groups { (members(summary, group)) }
            (steps(cook, summary))
        }
    }
}

fn table(caption: &str, rows: impl IntoIterator<Item = (impl Render, impl Render)>) -> Markup {
    html! {
        table {
            caption { (caption) }
            @for (name, value) in rows { tr { th scope="row" { (name) } td { (value) } } }
        }
    }
}

fn food(entry: &FoodOrGroup) -> Markup {
    let f = entry.food;
    let mut rows = vec![
        ("Core, highest".to_owned(), format!("{:.1} °C after {}", f.core_c.peak, duration(f.core_c.peak_at_s))),
        ("Core, at the end".to_owned(), format!("{:.1} °C", f.core_c.end)),
        ("Mass, start → end".to_owned(), format!("{:.1} g → {:.1} g", f.mass_g.start, f.mass_g.end)),
        ("Water, evaporated".to_owned(), format!("{:.1} g", f.water_g.evaporated)),
        ("Juice, dripped".to_owned(), format!("{:.1} g", f.water_g.dripped)),
    ];
    rows.extend(
        f.denatured.iter().map(|(name, share)| (format!("{name}, changed"), format!("{:.0} %", 100.0 * share))),
    );
    let l = &f.log_reduction;
    rows.extend([
        ("Fat, rendered".to_owned(), format!("{:.1} g", f.fat_rendered_g)),
        ("Volume over raw".to_owned(), format!("{:.1} %", f.shape.volume_pct)),
        ("Thickness".to_owned(), format!("{:.1} mm", f.shape.thickness_mm)),
        ("Hardness over raw".to_owned(), format!("{:.1}", f.hardness_index)),
        ("Juiciness".to_owned(), format!("{:.0} %", f.juiciness_pct)),
        ("Elastic modulus".to_owned(), format!("{:.0} kPa", f.elastic_modulus_kpa)),
        (format!("{} log reduction, core · surface", l.germ), format!("{:.1} · {:.1}", l.core, l.surface)),
    ]);
    rows.extend(surface("Top", &f.surfaces.top));
    rows.extend(surface("Bottom", &f.surfaces.bottom));
    rows.push(("Nodes of the mesh".to_owned(), f.nodes.to_string()));
    let means = if entry.group { format!("means of {} × ", entry.members.len()) } else { String::new() };
    table(&format!("{} ({means}{})", f.id, f.kind), rows)
}

fn surface(name: &str, s: &Surface) -> [(String, String); 3] {
    let [l, a, b] = s.lab;
    [
        (format!("{name}, at the end"), format!("{:.1} °C", s.temperature_c)),
        (format!("{name}, browned · charred"), format!("{:.0} % · {:.0} %", s.browned_pct, s.charred_pct)),
        (format!("{name}, L* a* b*"), format!("{l:.1}  {a:.1}  {b:.1}")),
    ]
}

/// Returns a table with one line for each piece of a group.
fn members(summary: &Summary, group: &GroupSummary) -> Markup {
    let heads =
        ["piece", "core, highest", "core, at the end", "mass, start → end", "lost", "browned, bottom · top", "place"];
    html! {
        table.steps {
            caption { (group.mean.id) ", piece by piece" }
            (page::heads(heads))
            @for food in &summary.foods[group.members.clone()] {
                tr { th scope="row" { (food.id) } @for cell in member(food) { td { (cell) } } }
            }
        }
    }
}

fn member(f: &FoodSummary) -> [String; 6] {
    [
        format!("{:.1} °C", f.core_c.peak),
        format!("{:.1} °C", f.core_c.end),
        format!("{:.1} g → {:.1} g", f.mass_g.start, f.mass_g.end),
        format!("{:.1} %", f.lost_pct),
        format!("{:.0} % · {:.0} %", f.surfaces.bottom.browned_pct, f.surfaces.top.browned_pct),
        f.place.to_owned(),
    ]
}

fn pan(s: &Summary) -> Markup {
    let celsius = |c: Option<f64>| c.map_or_else(|| "–".to_owned(), |c| format!("{c:.1} °C"));
    let p = &s.pan_c;
    let rows = [
        ("At the first put", p.at_first_put),
        ("Lowest after it", p.lowest_after_first_put),
        ("Highest", Some(p.peak)),
        ("At the end", Some(p.end)),
    ];
    table("Pan, mean of the floor", rows.map(|(name, c)| (name, celsius(c))))
}

fn energy(s: &Summary) -> Markup {
    let e = &s.energy_j;
    let entries = [
        ("Hob, electrical", e.hob),
        ("Stored in the pan", e.pan_stored),
        ("Stored in food", e.food_stored),
        ("To the air", e.air),
        ("Evaporation", e.evaporation),
        ("Hob losses, glass, board, cloth, juice", e.other),
        ("Imbalance", e.imbalance),
    ];
    let share = |j: f64| if e.hob > 0.0 { 100.0 * j / e.hob } else { 0.0 };
    // Adding zero turns −0.0 into 0.0, which would print as −0.0.
    let tidy = |v: f64| (v * 10.0).round() / 10.0 + 0.0;
    let value = |j: f64| {
        html! { (format!("{:.1} kJ", tidy(j / 1e3))) small { (format!("{:.1} %", tidy(share(j)))) } }
    };
    table("Energy", entries.map(|(name, j)| (name, value(j))))
}

fn steps(cook: &Cook, summary: &Summary) -> Markup {
    let entries = summary.foods_and_groups();
    let cores = entries.iter().map(|entry| format!("core of {}", entry.food.id));
    let heads = ["time, min:s", "step", "pan"].map(str::to_owned).into_iter().chain(cores);
    html! {
        table.steps {
            caption { "Steps" }
            (page::heads(heads))
            @for step in &summary.steps { (step_row(cook, &entries, step)) }
        }
    }
}

fn step_row(cook: &Cook, entries: &[FoodOrGroup], step: &StepRecord) -> Markup {
    html! {
        tr {
            td { (wording::clock(step.time_s)) }
            th scope="row" { (wording::step(step)) }
            @if let Some(row) = super::row_at(cook, step.time_s) {
                td { (format!("{:.1} °C", row.pan_c)) }
                @for entry in entries { td { (format!("{:.1} °C", row.mean(&entry.members)[0])) } }
            }
        }
    }
}

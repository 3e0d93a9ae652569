//! The tables: food, pan, energy, steps.

use saute_recipe::group_summary::GroupSummary;
use saute_recipe::step_record::StepRecord;
use saute_recipe::summary::{FoodSummary, Surface, Told};
use saute_recipe::{Cook, Summary};

use super::markup::escaped;
use crate::wording::{self, duration};

/// All tables.
pub fn section(cook: &Cook, summary: &Summary) -> String {
    let foods: String = summary.told().iter().map(food).collect();
    let members: String = summary.groups.iter().map(|group| members(summary, group)).collect();
    format!(
        "<section><h2>Numbers</h2><div class=\"tables\">{foods}{}{}</div>{members}{}</section>",
        pan(summary),
        energy(summary),
        steps(cook, summary)
    )
}

fn table(caption: &str, rows: &[(String, String)]) -> String {
    let rows: String =
        rows.iter().map(|(name, value)| format!("<tr><th scope=\"row\">{name}</th><td>{value}</td></tr>")).collect();
    format!("<table><caption>{caption}</caption>{rows}</table>")
}

fn food(told: &Told) -> String {
    let f = told.food;
    let mut rows = vec![
        ("Core, highest".to_owned(), format!("{:.1} °C after {}", f.core_c.peak, duration(f.core_c.peak_at_s))),
        ("Core, at the end".to_owned(), format!("{:.1} °C", f.core_c.end)),
        ("Mass, start → end".to_owned(), format!("{:.1} g → {:.1} g", f.mass_g.start, f.mass_g.end)),
        ("Water, evaporated".to_owned(), format!("{:.1} g", f.water_g.evaporated)),
        ("Juice, dripped".to_owned(), format!("{:.1} g", f.water_g.dripped)),
    ];
    let changed = f.denatured.iter();
    rows.extend(
        changed.map(|(name, share)| (format!("{}, changed", escaped(name)), format!("{:.0} %", 100.0 * share))),
    );
    rows.push(("Fat, rendered".to_owned(), format!("{:.1} g", f.fat_rendered_g)));
    rows.push(("Volume over raw".to_owned(), format!("{:.1} %", f.shape.volume_pct)));
    rows.push(("Thickness".to_owned(), format!("{:.1} mm", f.shape.thickness_mm)));
    rows.push(("Hardness over raw".to_owned(), format!("{:.1}", f.hardness_index)));
    rows.push(("Juiciness".to_owned(), format!("{:.0} %", f.juiciness_pct)));
    rows.push(("Elastic modulus".to_owned(), format!("{:.0} kPa", f.elastic_modulus_kpa)));
    let l = &f.log_reduction;
    rows.push(("E. coli log reduction, core · surface".to_owned(), format!("{:.1} · {:.1}", l.core, l.surface)));
    rows.extend(surface("Top", &f.surfaces.top));
    rows.extend(surface("Bottom", &f.surfaces.bottom));
    rows.push(("Nodes of the mesh".to_owned(), f.nodes.to_string()));
    let means = if told.group { format!("means of {} × ", told.members.len()) } else { String::new() };
    table(&format!("{} ({means}{})", escaped(&f.id), escaped(&f.kind)), &rows)
}

/// A line for each piece of a group.
fn members(summary: &Summary, group: &GroupSummary) -> String {
    let rows: String = summary.foods[group.members.clone()].iter().map(member).collect();
    let heads = ["core, highest", "core, at the end", "mass, start → end", "lost", "browned, bottom · top", "place"];
    let heads: String = heads.iter().map(|head| format!("<th scope=\"col\">{head}</th>")).collect();
    format!(
        "<table class=\"steps\"><caption>{}, piece by piece</caption><tr><th scope=\"col\">piece</th>{heads}</tr>{rows}</table>",
        escaped(&group.mean.id)
    )
}

fn member(f: &FoodSummary) -> String {
    let cells = [
        format!("{:.1} °C", f.core_c.peak),
        format!("{:.1} °C", f.core_c.end),
        format!("{:.1} g → {:.1} g", f.mass_g.start, f.mass_g.end),
        format!("{:.1} %", f.lost_pct),
        format!("{:.0} % · {:.0} %", f.surfaces.bottom.browned_pct, f.surfaces.top.browned_pct),
        f.place.to_owned(),
    ];
    let cells: String = cells.iter().map(|cell| format!("<td>{cell}</td>")).collect();
    format!("<tr><th scope=\"row\">{}</th>{cells}</tr>", escaped(&f.id))
}

fn surface(name: &str, s: &Surface) -> [(String, String); 3] {
    let [l, a, b] = s.lab;
    [
        (format!("{name}, at the end"), format!("{:.1} °C", s.temperature_c)),
        (format!("{name}, browned · charred"), format!("{:.0} % · {:.0} %", s.browned_pct, s.charred_pct)),
        (format!("{name}, L* a* b*"), format!("{l:.1}  {a:.1}  {b:.1}")),
    ]
}

fn pan(s: &Summary) -> String {
    let celsius = |c: Option<f64>| c.map_or_else(|| "–".to_owned(), |c| format!("{c:.1} °C"));
    let p = &s.pan_c;
    let rows = [
        ("At the first put", p.at_first_put),
        ("Lowest after it", p.lowest_after_first_put),
        ("Highest", Some(p.peak)),
        ("At the end", Some(p.end)),
    ];
    table("Pan, mean of the floor", &rows.map(|(name, c)| (name.to_owned(), celsius(c))))
}

fn energy(s: &Summary) -> String {
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
    let rows: Vec<(String, String)> = entries
        .iter()
        .map(|(name, j)| {
            ((*name).to_owned(), format!("{:.1} kJ<small>{:.1} %</small>", tidy(j / 1e3), tidy(share(*j))))
        })
        .collect();
    table("Energy", &rows)
}

fn steps(cook: &Cook, summary: &Summary) -> String {
    let told = summary.told();
    let name = |t: &Told| format!("<th scope=\"col\">core of {}</th>", escaped(&t.food.id));
    let names: String = told.iter().map(name).collect();
    let rows: String = summary.steps.iter().map(|s| step_row(cook, &told, s)).collect();
    format!(
        "<table class=\"steps\"><caption>Steps</caption><tr><th scope=\"col\">time</th><th scope=\"col\">step</th>\
         <th scope=\"col\">pan</th>{names}</tr>{rows}</table>"
    )
}

fn step_row(cook: &Cook, told: &[Told], step: &StepRecord) -> String {
    let cells: String = super::row_at(cook, step.time_s).map_or(String::new(), |r| {
        let cores = told.iter().map(|t| r.mean(&t.members)[0]);
        std::iter::once(r.pan_c).chain(cores).map(|c| format!("<td>{c:.1} °C</td>")).collect()
    });
    format!("<tr><td>{:.1} s</td><th scope=\"row\">{}</th>{cells}</tr>", step.time_s, escaped(&wording::step(step)))
}

//! The report of a sweep: a page that needs no other file.

use maud::{Markup, html};
use saute_sweep::Manifest;
use saute_sweep::design::DesignKind;

use super::{Indices, Sensitivity, bars, tables};
use crate::page;

/// Returns the whole page.
pub fn page(manifest: &Manifest, found: &[Sensitivity], plotted: &[String]) -> String {
    let title = format!("What matters in {}", manifest.recipe);
    let shown: Vec<&Sensitivity> = found.iter().filter(|one| plotted.contains(&one.heading.name)).collect();
    let content = html! {
        header { h1 { (title) } p { (rows(manifest)) } }
        @if shown.is_empty() { p.notice { "None of the numbers varied, or too few rows have one." } }
        @for one in shown { (section(manifest, one)) }
        (method(manifest))
        footer { "saute " (manifest.version) ". All numbers are in sensitivity.csv." }
    };
    page::whole(&title, "", &content)
}

fn rows(manifest: &Manifest) -> String {
    let blocks = if manifest.design.kind == DesignKind::Morris { "trajectories" } else { "base rows" };
    format!(
        "{} cooks: {} {blocks}, {} values, seed {}.",
        manifest.rows,
        manifest.design.n,
        manifest.varied.len(),
        manifest.design.seed
    )
}

fn section(manifest: &Manifest, one: &Sensitivity) -> Markup {
    let left_out = match &one.found {
        Indices::Sobol(indices) => indices.left_out,
        Indices::Effects(effects) => effects.left_out,
    };
    html! {
        section {
            h2 { (one.heading.name) @if one.heading.unit != "-" { " [" (one.heading.unit) "]" } }
            (bars::figure(manifest, one))
            table.steps {
                (page::heads(["value", "what it does"]))
                @for (place, path) in manifest.varied.iter().enumerate() {
                    tr { th scope="row" { (path) } td style="white-space: normal" { (tables::words(one, place)) } }
                }
            }
            @if left_out > 0 { p { (left_out) " left out, as a cook of them failed or has no such number." } }
        }
    }
}

fn method(manifest: &Manifest) -> Markup {
    let text = if manifest.design.kind == DesignKind::Morris {
        "Elementary effects (Morris 1991): one value after the other makes a step of two thirds of its range; the change of the number \
         over the step is taken to the whole range. The mean says how the number goes with the value, the mean size how much the value \
         matters, the deviation how much that depends on the other values."
    } else {
        "Sobol' indices (Saltelli and others 2010): the share of the number's variance that a value causes alone, and alone and with \
         others. If the shares alone add up to 100 %, the values do not interact. Small negative shares are scatter: more base rows \
         make it smaller. Intervals: base rows are drawn 400 times with replacement; an interval holds the middle 90 % of the draws."
    };
    html! { section { h2 { "Method" } p { (text) } } }
}

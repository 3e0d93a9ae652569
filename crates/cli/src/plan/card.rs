//! The kitchen card: a plan on one sheet to be printed and hung up.

use maud::{DOCTYPE, Markup, PreEscaped, html};
use saute_kitchen::Library;
use saute_plan::schedule::Plan;

use super::steps::{Deed, Step, steps};
use super::{cues, text};

const STYLE: &str = include_str!("card.css");

/// Returns the whole page; it needs no other file.
pub fn page(plan: &Plan, library: &Library) -> String {
    let title = text::heading(&plan.order);
    let food = library.foods.get(&plan.order.food).map_or(plan.order.food.as_str(), |food| food.name.as_str());
    let page = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                title { (title) }
                style { (PreEscaped(STYLE)) }
            }
            body {
                main {
                    h1 { (food) ", " (plan.order.goal.name) }
                    p { (title) }
                    @for why in text::why_not(plan).iter().take(1) { p.notice { (why) } }
                    table {
                        @for step in steps(plan) { (row(&step, plan, library)) }
                    }
                    (promise(plan))
                    (changes(plan))
                    p.small {
                        "Times are minutes and seconds since the hob is switched on. saute " (env!("CARGO_PKG_VERSION"))
                        ": a simulation, for learning, not for judging whether food is safe to eat."
                    }
                }
            }
        }
    };
    page.into_string()
}

fn row(step: &Step, plan: &Plan, library: &Library) -> Markup {
    let has_cue = !matches!(step.deed, Deed::Power(_));
    let cue = plan.cues.iter().find(|cue| has_cue && cue.at_s == step.at_s);
    html! {
        tr {
            td.time { (text::minutes(step.at_s)) }
            td.deed { (step.deed.words()) }
            td { (cues::words(&step.deed, cue, plan, library)) }
        }
    }
}

fn promise(plan: &Plan) -> Markup {
    html! {
        h2 { "Promised" }
        p {
            (format!("Middle {:.0} °C at its highest. ", plan.promised.core_peak_c))
            (text::on_target(plan)) ". " (text::crust(&plan.promised)) "."
        }
    }
}

fn changes(plan: &Plan) -> Markup {
    html! {
        h2 { "If something is different and the times stay the same" }
        table.changes {
            @for s in &plan.sensitivity { tr { th { (s.change.words()) } td { (text::changed(s)) } } }
        }
    }
}

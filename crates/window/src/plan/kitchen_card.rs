//! The kitchen card: a plan on one sheet to be printed and hung up, as a page that needs no other file.

use maud::{DOCTYPE, Markup, PreEscaped, html};
use saute_kitchen::Library;
use saute_plan::schedule::{Plan, Step};

use crate::settings::Settings;
use saute_words::clock::clock;
use saute_words::language::Language;
use saute_words::{cue_words, plan_words};

const STYLE: &str = include_str!("kitchen_card.css");

/// Returns the whole page in the language and the unit of the settings.
pub fn page(plan: &Plan, library: &Library, settings: &Settings) -> String {
    let l = settings.language;
    let title = plan_words::heading(&plan.order, library, settings.speech());
    let food = library.foods.get(&plan.order.food).map_or(plan.order.food.as_str(), |food| food.name.as_str());
    let page = html! {
        (DOCTYPE)
        html lang=(if l == Language::Japanese { "ja" } else { "en" }) {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                title { (title) }
                style { (PreEscaped(STYLE)) }
            }
            body {
                main {
                    h1 { (l.called("food", food)) ", " (plan_words::target(&plan.order.goal, settings.speech())) }
                    p { (title) }
                    @if let Some(why) = plan_words::why_not(plan, settings.speech()) { p.notice { (why) } }
                    table {
                        @for step in plan.steps() { (row(&step, plan, library, settings)) }
                    }
                    (promise(plan, settings))
                    (changes(plan, settings))
                    p.small { (l.fill("plan.card_foot", &[("version", &env!("CARGO_PKG_VERSION"))])) }
                }
            }
        }
    };
    page.into_string()
}

fn row(step: &Step, plan: &Plan, library: &Library, settings: &Settings) -> Markup {
    let sense = plan.sense(step, library).map(|sense| cue_words::sense(&sense, settings.speech()));
    html! {
        tr {
            td.time { (clock(f64::from(step.at_s))) }
            td.deed { (cue_words::deed(&step.deed, settings.language)) }
            td { (sense.unwrap_or_default()) }
        }
    }
}

fn promise(plan: &Plan, settings: &Settings) -> Markup {
    let l = settings.language;
    let core = settings.temperature(plan.promised.core_peak_c);
    html! {
        h2 { (l.text("plan.promised")) }
        p {
            (l.fill("plan.middle", &[("core", &core)])) " "
            (plan_words::on_target(plan, l)) ". " (plan_words::crust(&plan.promised, l)) "."
        }
    }
}

fn changes(plan: &Plan, settings: &Settings) -> Markup {
    html! {
        h2 { (settings.language.text("plan.if_different")) }
        table.changes {
            @for s in &plan.sensitivity {
                tr { th { (plan_words::change(s.change, settings.speech())) } td { (plan_words::changed(s, settings.speech())) } }
            }
        }
    }
}

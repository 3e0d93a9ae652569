//! The kitchen card: a plan on one sheet to be printed and hung up, as a page that needs no other file.

use maud::{DOCTYPE, Markup, PreEscaped, html};
use saute_kitchen::Library;
use saute_plan::schedule::{Plan, Step};

use saute_words::clock::clock;
use saute_words::speech::Speech;
use saute_words::{cue_words, plan_words};

const STYLE: &str = include_str!("kitchen_card.css");

/// Returns the whole page in a language and a unit.
pub fn page(plan: &Plan, library: &Library, speech: Speech) -> String {
    let l = speech.language;
    let title = plan_words::heading(&plan.order, library, speech);
    let food = library.foods.get(&plan.order.food).map_or(plan.order.food.as_str(), |food| food.name_in(l.code()));
    let page = html! {
        (DOCTYPE)
        html lang=(l.code()) {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                title { (title) }
                style { (PreEscaped(STYLE)) }
            }
            body {
                main {
                    h1 { (food) ", " (plan_words::target(&plan.order.goal, speech)) }
                    p { (title) }
                    @if let Some(why) = plan_words::why_not(plan, speech) { p.notice { (why) } }
                    @if plan.is_rough { p.notice { (l.text("plan.rough")) } }
                    table {
                        @for step in plan.steps() { (row(&step, plan, library, speech)) }
                    }
                    (promise(plan, speech))
                    @if !plan.sensitivity.is_empty() { (changes(plan, speech)) }
                    p.small { (l.text("plan.honest")) }
                    p.small { (l.fill("plan.card_foot", &[("version", &env!("CARGO_PKG_VERSION"))])) }
                }
            }
        }
    };
    page.into_string()
}

fn row(step: &Step, plan: &Plan, library: &Library, speech: Speech) -> Markup {
    let sense = plan.sense(step, library).map(|sense| cue_words::sense(&sense, speech));
    html! {
        tr {
            td.time { (clock(f64::from(step.at_s))) }
            td.deed { (cue_words::deed(&step.deed, speech.language)) }
            td { (sense.unwrap_or_default()) }
        }
    }
}

fn promise(plan: &Plan, speech: Speech) -> Markup {
    let l = speech.language;
    let core = speech.temperature(plan.promised.core_peak_c);
    html! {
        h2 { (l.text("plan.promised")) }
        p {
            (l.fill("plan.middle", &[("core", &core)])) " "
            (plan_words::on_target(plan, l)) ". " (plan_words::crust(&plan.promised, l)) "."
        }
    }
}

fn changes(plan: &Plan, speech: Speech) -> Markup {
    html! {
        h2 { (speech.language.text("plan.if_different")) }
        table.changes {
            @for s in &plan.sensitivity {
                tr { th { (plan_words::change(s.change, speech)) } td { (plan_words::changed(s, speech)) } }
            }
        }
    }
}

//! The plan as plain text, and as a recipe file with its promise as a comment.

use std::fmt::Write;
use std::time::Duration;

use saute_plan::goal::Shortfall;
use saute_plan::schedule::{Deed, Order, Plan, Step};
use saute_words::cue_words;
use saute_words::language::Language;
use saute_words::plan_words::{changed, crust, on_target};
use saute_words::speech::Speech;

use crate::wording::clock;

/// Language of the command.
const EN: Language = Language::ENGLISH;

/// Returns the plan on one screen.
pub fn text(plan: &Plan, wall: Duration) -> String {
    let goal = &plan.order.goal;
    let best = if plan.shortfalls().is_empty() { "best" } else { "target not met; best" };
    let rough = if plan.is_rough { "; cooked on a coarse mesh only" } else { "" };
    let mut text = format!(
        "{}\n{best} of {} candidates in {:.1} s{rough}\n",
        heading(&plan.order),
        plan.candidates,
        wall.as_secs_f64()
    );
    text.push_str("\nschedule (min:s)\n");
    for step in plan.steps() {
        row(&mut text, &minutes(step.at_s), &format!("{}{}", cue_words::deed(&step.deed, EN), seen(plan, &step)));
    }
    let _ = writeln!(text, "\npromised (scale: {})", goal.scale.name);
    row(&mut text, "core", &format!("{:.1} °C at its highest", plan.promised.core_peak_c));
    row(&mut text, "on target", &on_target(plan, EN));
    row(&mut text, "crust", &crust(&plan.promised, EN));
    row(&mut text, "mass", &format!("−{:.1} %", plan.promised.lost_pct));
    row(&mut text, "score", &plan.score.to_string());
    if !plan.sensitivity.is_empty() {
        text.push_str("\nif something is different and the times stay the same\n");
    }
    plan.sensitivity.iter().for_each(|s| row(&mut text, &s.change.words(), &changed(s, Speech::default())));
    let _ = writeln!(text, "\n{}", EN.text("plan.honest"));
    text
}

/// Returns what is cooked to what: `beef-lean 120 × 80 × 30 mm from 5 °C to medium, in cast-iron-26`.
pub fn heading(order: &Order) -> String {
    let size: Vec<String> = order.size_mm.iter().map(f64::to_string).collect();
    let count = order.count.map_or(String::new(), |count| format!("{count} × "));
    let Order { food, initial_c, pan, goal, .. } = order;
    format!("{count}{food} {} mm from {initial_c} °C to {}, in {pan}", size.join(" × "), goal.name)
}

/// Returns a time as minutes and seconds.
pub fn minutes(at_s: u32) -> String {
    clock(f64::from(at_s)).trim_end_matches(".0").to_owned()
}

/// Returns the text of the recipe, under what it promises.
pub fn recipe(plan: &Plan) -> String {
    let mut lines = vec![
        format!("Planned by saute {}: {}.", env!("CARGO_PKG_VERSION"), heading(&plan.order)),
        format!("Promised: core {:.1} °C at its highest, {};", plan.promised.core_peak_c, on_target(plan, EN)),
        format!("{}.", crust(&plan.promised, EN)),
    ];
    lines.extend(why_not(plan).first().map(|why| format!("The {why}.")));
    lines.extend(plan.is_rough.then(|| "The search was stopped: this was cooked on a coarse mesh only.".to_owned()));
    let comment: String = lines.iter().map(|line| format!("# {line}\n")).collect();
    comment + &plan.recipe_text()
}

/// Returns why the target is not met, with a remedy; nothing if it is.
pub fn why_not(plan: &Plan) -> Vec<String> {
    let shortfalls = plan.shortfalls();
    if shortfalls.is_empty() {
        return Vec::new();
    }
    let words: Vec<String> = shortfalls.iter().map(|s| s.words(&plan.promised, &plan.order.goal)).collect();
    let so_far = if plan.is_stopped { " so far" } else { "" };
    let target = format!("target {} is not met{so_far}: {}", plan.order.goal.name, words.join("; "));
    let remedy = if plan.is_stopped { "let the search come to its end" } else { remedy(&shortfalls) };
    vec![target, format!("  remedy: {remedy}")]
}

fn remedy(shortfalls: &[Shortfall]) -> &'static str {
    let has = |shortfall| shortfalls.contains(&shortfall);
    if has(Shortfall::Crust) && has(Shortfall::Overcooked) {
        return "a thicker piece, a colder start, or less crust (--crust-pct): the inside is done before the faces are brown";
    }
    match shortfalls.first() {
        Some(Shortfall::Undercooked) => "a thinner piece, a warmer start, or more powers (--hob)",
        Some(Shortfall::Overcooked) => "a thicker piece, a colder start, or lower powers (--hob)",
        Some(Shortfall::Share) => "a thicker piece, or more flips (--max-flips)",
        Some(Shortfall::Crust) => "a thicker piece, a colder start, less crust (--crust-pct), or higher powers (--hob)",
        Some(Shortfall::Burnt | Shortfall::Fire) => "lower powers (--hob), or less crust (--crust-pct)",
        None => "none is needed",
    }
}

/// Returns what there is to see when a step comes.
fn seen(plan: &Plan, step: &Step) -> String {
    let Some(cue) = plan.cue(step) else { return String::new() };
    match step.deed {
        Deed::Put => format!(" (pan at {:.0} °C)", cue.pan_c),
        Deed::Flip(_) => format!(" (core {:.0} °C, underside {:.0} % brown)", cue.core_c, cue.browned_pct),
        Deed::Pull => format!(" (core {:.0} °C)", cue.core_c),
        Deed::Power(_) | Deed::Serve => String::new(),
    }
}

fn row(text: &mut String, name: &str, value: &str) {
    // The window keeps numbers and units together; a terminal is searched for plain spaces.
    let [name, value] = [name, value].map(|text| text.replace('\u{a0}', " "));
    // Writing to a string cannot fail.
    let _ = writeln!(text, "  {name:<18}{value}");
}

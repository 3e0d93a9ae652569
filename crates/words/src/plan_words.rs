//! A plan in words: what is cooked to what, what is promised, what changes it, and why a target is missed.

use saute_kitchen::Library;
use saute_plan::goal::{Goal, Outcome, Shortfall};
use saute_plan::schedule::{Change, Order, Plan, Sensitivity, Stage};

use crate::doneness_words;
use crate::language::Language;
use crate::speech::Speech;

/// The target: a class in the language, or the temperature of the core.
pub fn target(goal: &Goal, speech: Speech) -> String {
    let l = speech.language;
    if goal.scale.class.iter().any(|class| class.name == goal.name) {
        return doneness_words::class(&goal.scale, &goal.name, l).to_owned();
    }
    l.fill("plan.core_of", &[("core", &speech.temperature(goal.aim))])
}

/// What is cooked to what.
pub fn heading(order: &Order, library: &Library, speech: Speech) -> String {
    let l = speech.language;
    let size: Vec<String> = order.size_mm.iter().map(|mm| format!("{mm:.0}")).collect();
    let food = library.foods.get(&order.food).map_or(order.food.as_str(), |food| food.name_in(l.code()));
    let food = order.count.map_or(food.to_owned(), |count| format!("{count} × {food}"));
    let pan = library.pans.get(&order.pan).map_or(order.pan.as_str(), |pan| l.called("pan", &pan.name));
    let (size, start) = (size.join(" × "), speech.temperature(order.initial_c));
    let target = target(&order.goal, speech);
    l.fill("plan.heading", &[("food", &food), ("size", &size), ("start", &start), ("target", &target), ("pan", &pan)])
}

/// The share of the section that is on target.
pub fn on_target(plan: &Plan, l: Language) -> String {
    let Outcome { target_share_pct, beyond_pct, .. } = plan.promised;
    let (share, beyond) = (format!("{target_share_pct:.0}"), format!("{beyond_pct:.0}"));
    let key = if plan.is_stopped { "plan.on_target_so_far" } else { "plan.on_target" };
    l.fill(key, &[("share", &share), ("class", &class(&plan.order.goal, l)), ("beyond", &beyond)])
}

/// The crust of both faces.
pub fn crust(outcome: &Outcome, l: Language) -> String {
    let [both, least, charred] =
        [outcome.crust_pct, outcome.least_crust_pct, outcome.charred_pct].map(|pct| format!("{pct:.0}"));
    l.fill("plan.crust_of", &[("crust", &both), ("least", &least), ("charred", &charred)])
}

/// What comes of a change.
pub fn changed(s: &Sensitivity, speech: Speech) -> String {
    let l = speech.language;
    let [share, crust] = [s.target_share_pct, s.crust_pct].map(|pct| format!("{pct:.0}"));
    let (core, met) =
        (speech.fine_temperature(s.core_peak_c), if s.missing.is_none() { "" } else { l.text("plan.misses") });
    l.fill("plan.changed", &[("core", &core), ("share", &share), ("crust", &crust), ("met", &met)])
}

/// What is different, in a few words.
pub fn change(change: Change, speech: Speech) -> String {
    let l = speech.language;
    match change {
        Change::ThicknessMm(mm) => l.fill("plan.by_thickness", &[("by", &format!("{mm:+}"))]),
        Change::InitialK(k) => l.fill("plan.by_start", &[("by", &difference(k, speech))]),
        Change::PowerPct(pct) => l.fill("plan.by_power", &[("by", &format!("{pct:+}"))]),
    }
}

fn difference(kelvin: f64, speech: Speech) -> String {
    let shown = if speech.fahrenheit { 1.8 * kelvin } else { kelvin };
    format!("{shown:+} {}", speech.unit())
}

/// What comes of a change, as a sentence.
pub fn sentence(s: &Sensitivity, goal: &Goal, speech: Speech) -> String {
    let l = speech.language;
    let by = |value: f64| format!("{:.0}", value.abs());
    let what = match s.change {
        Change::ThicknessMm(mm) if mm > 0.0 => l.fill("plan.thicker", &[("by", &by(mm))]),
        Change::ThicknessMm(mm) => l.fill("plan.thinner", &[("by", &by(mm))]),
        Change::InitialK(k) => {
            let shown = format!("{:.0} {}", if speech.fahrenheit { 1.8 * k } else { k }.abs(), speech.unit());
            l.fill(if k > 0.0 { "plan.warmer" } else { "plan.colder" }, &[("by", &shown)])
        }
        Change::PowerPct(pct) if pct > 0.0 => l.fill("plan.stronger", &[("by", &by(pct))]),
        Change::PowerPct(pct) => l.fill("plan.weaker", &[("by", &by(pct))]),
    };
    let verdict = l.text(match s.missing {
        None => "plan.then_met",
        Some(Shortfall::Undercooked) => "plan.then_under",
        Some(Shortfall::Overcooked) => "plan.then_over",
        Some(Shortfall::Share) => "plan.then_missed",
        Some(Shortfall::Crust) => "plan.then_pale",
        Some(Shortfall::Burnt | Shortfall::Fire) => "plan.then_burnt",
    });
    let (core, share) = (speech.temperature(s.core_peak_c), format!("{:.0}", s.target_share_pct));
    let parts: [(&str, &dyn std::fmt::Display); 5] =
        [("what", &what), ("core", &core), ("share", &share), ("class", &class(goal, l)), ("verdict", &verdict)];
    l.fill("plan.then", &parts)
}

/// The class of a goal; of a target temperature, that it is on target.
pub fn class(goal: &Goal, l: Language) -> String {
    match goal.scale.class.get(goal.class) {
        Some(class) if class.name == "on target" => l.text("plan.on_target_class").to_owned(),
        Some(class) => doneness_words::class(&goal.scale, &class.name, l).to_owned(),
        None => String::new(),
    }
}

/// Why the target is missed, and what would help; none if it is met.
pub fn why_not(plan: &Plan, speech: Speech) -> Option<String> {
    let (l, shortfalls) = (speech.language, plan.shortfalls());
    let first = shortfalls.first()?;
    let words: Vec<String> = shortfalls.iter().map(|s| shortfall(*s, plan, speech)).collect();
    let has = |shortfall| shortfalls.contains(&shortfall);
    let remedy = match first {
        _ if has(Shortfall::Crust) && has(Shortfall::Overcooked) => "plan.try_all",
        Shortfall::Undercooked | Shortfall::Share => "plan.try_thinner",
        Shortfall::Overcooked => "plan.try_thicker",
        Shortfall::Crust => "plan.try_less_crust",
        Shortfall::Burnt | Shortfall::Fire => "plan.try_gentler",
    };
    let why = words.join(l.text("doneness.list_joint"));
    let target = target(&plan.order.goal, speech);
    if plan.is_stopped {
        return Some(l.fill("plan.not_met_so_far", &[("target", &target), ("why", &why)]));
    }
    Some(l.fill("plan.not_met", &[("target", &target), ("why", &why), ("remedy", &l.text(remedy))]))
}

fn shortfall(shortfall: Shortfall, plan: &Plan, speech: Speech) -> String {
    let (l, outcome, goal) = (speech.language, &plan.promised, &plan.order.goal);
    let value = |value: f64| if goal.unit() == "%" { format!("{value:.0} %") } else { speech.temperature(value) };
    let core = value(outcome.at_core);
    match shortfall {
        Shortfall::Undercooked => l.fill("plan.undercooked", &[("core", &core), ("wanted", &value(goal.core[0]))]),
        Shortfall::Overcooked => l.fill("plan.overcooked", &[("core", &core), ("wanted", &value(goal.core[1]))]),
        Shortfall::Share => {
            let [share, wanted] = [outcome.target_share_pct, goal.least_share_pct].map(|pct| format!("{pct:.0}"));
            l.fill("plan.too_little", &[("share", &share), ("wanted", &wanted)])
        }
        Shortfall::Crust => {
            let (least, wanted) = (format!("{:.0}", outcome.least_crust_pct), format!("{:.0}", goal.crust_pct));
            l.fill("plan.pale", &[("least", &least), ("wanted", &wanted)])
        }
        Shortfall::Burnt => l.fill("plan.burnt", &[("charred", &format!("{:.0}", outcome.charred_pct))]),
        Shortfall::Fire => l.text("plan.fire").to_owned(),
    }
}

/// Key of what a search does now.
pub fn stage(stage: Stage) -> &'static str {
    match stage {
        Stage::Seeds => "plan.stage_first",
        Stage::Refine(_) => "plan.stage_refine",
        Stage::Finish => "plan.stage_finish",
        Stage::Vary | Stage::Done => "plan.stage_vary",
    }
}

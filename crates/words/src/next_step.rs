//! The next step of a recipe that plays, in the language of the window.

use saute_kitchen::{Library, celsius};
use saute_recipe::recipe::{ALL, Quantity};
use saute_recipe::{Action, Condition, Measured, Runner, Target, Trigger};

use crate::clock::clock;
use crate::piece_words::name;
use crate::speech::Speech;

/// The next step: what, and when.
pub fn words(runner: &Runner, library: &Library, speech: Speech) -> String {
    let l = speech.language;
    let Some(step) = runner.recipe().steps.get(runner.waiting_step()) else { return l.text("awaits.end").to_owned() };
    let repeat = match &step.action {
        Action::Repeat(repeat) => Some(repeat),
        _ => None,
    };
    let once = what(repeat.map_or(&step.action, |repeat| &repeat.action), library, speech);
    let at = |what: &str, seconds: f64| l.fill("awaits.at", &[("what", &what), ("time", &clock(seconds))]);
    if let Some(seconds) = runner.next_repetition_s() {
        return at(&once, seconds);
    }
    let what = match repeat {
        Some(repeat) => l.fill("awaits.repeats", &[("repetition", &once), ("seconds", &repeat.every_s)]),
        None => once,
    };
    match &step.trigger {
        Trigger::At(seconds) => at(&what, *seconds),
        Trigger::After(seconds) => at(&what, runner.ready_at_s() + seconds),
        Trigger::When(condition) => when(&what, condition, library, speech),
    }
}

/// An action with its foods.
fn what(action: &Action, library: &Library, speech: Speech) -> String {
    let l = speech.language;
    let deed = l.find(&format!("deed.{}", action.name())).unwrap_or(action.name());
    match action.target().map(|target| target.name.as_str()) {
        Some(ALL) => l.fill("awaits.deed_of", &[("deed", &deed), ("food", &l.text("awaits.every"))]),
        Some(food) => l.fill("awaits.deed_of", &[("deed", &deed), ("food", &name(food, library, l))]),
        None => deed.to_owned(),
    }
}

/// A step that waits for the pan or for foods.
fn when(what: &str, condition: &Condition, library: &Library, speech: Speech) -> String {
    let l = speech.language;
    let food = match &condition.measured {
        Measured::Pan => String::new(),
        Measured::Food { food, .. } => of(food, library, speech),
    };
    let (temperature, grams) = (speech.temperature(celsius(condition.value)), format!("{:.0}", 1e3 * condition.value));
    l.fill(key(condition), &[("what", &what), ("food", &food), ("temperature", &temperature), ("grams", &grams)])
}

/// The foods of a condition.
fn of(target: &Target, library: &Library, speech: Speech) -> String {
    let l = speech.language;
    match (target.group, target.name.as_str()) {
        (true, ALL) => l.text("awaits.every").to_owned(),
        (true, group) => l.fill("awaits.each", &[("group", &name(group, library, l))]),
        (false, food) => name(food, library, l),
    }
}

/// Key of the words for a condition: from the usual side of its quantity, or back to its value.
fn key(condition: &Condition) -> &'static str {
    let usual = condition.side == condition.measured.plain_side();
    let keys = match &condition.measured {
        Measured::Pan => ["awaits.pan", "awaits.pan_back"],
        Measured::Food { quantity, .. } => match quantity {
            Quantity::Core => ["awaits.core", "awaits.core_back"],
            Quantity::Top => ["awaits.top", "awaits.top_back"],
            Quantity::Bottom => ["awaits.bottom", "awaits.bottom_back"],
            Quantity::Mass => ["awaits.mass", "awaits.mass_back"],
        },
    };
    keys[usize::from(!usual)]
}

//! The next step of a recipe that plays, in the language of the window.

use saute_kitchen::celsius;
use saute_recipe::recipe::{ALL, Quantity};
use saute_recipe::{Runner, Target, Trigger};

use crate::settings::Settings;
use crate::words::piece_words::name;

/// The next step: what, and when.
pub fn words(runner: &Runner, settings: &Settings) -> String {
    let l = settings.language;
    let Some(action) = runner.waiting_action() else { return l.text("awaits.end").to_owned() };
    let (deed, food) = (action.name(), action.target().map(|target| target.name.as_str()));
    let Some(step) = runner.recipe().steps.get(runner.waiting_step()) else { return String::new() };
    let deed = l.find(&format!("deed.{deed}")).unwrap_or(deed);
    let what = match food {
        Some(ALL) => l.fill("awaits.deed_of", &[("deed", &deed), ("food", &l.text("awaits.every"))]),
        Some(food) => l.fill("awaits.deed_of", &[("deed", &deed), ("food", &name(food, l))]),
        None => deed.to_owned(),
    };
    let at = |seconds: f64| l.fill("awaits.at", &[("what", &what), ("seconds", &format!("{seconds:.0}"))]);
    match &step.trigger {
        Trigger::At(seconds) => at(*seconds),
        Trigger::After(seconds) => at(runner.ready_at_s() + seconds),
        Trigger::Pan(kelvin) => {
            l.fill("awaits.pan", &[("what", &what), ("temperature", &settings.temperature(celsius(*kelvin)))])
        }
        Trigger::Food { food, quantity, value } => when(settings, &what, food, *quantity, *value),
    }
}

/// A step that waits for foods.
fn when(settings: &Settings, what: &str, target: &Target, quantity: Quantity, value: f64) -> String {
    let l = settings.language;
    let food = match (target.group, target.name.as_str()) {
        (true, ALL) => l.text("awaits.every").to_owned(),
        (true, group) => l.fill("awaits.each", &[("group", &name(group, l))]),
        (false, food) => name(food, l),
    };
    let key = match quantity {
        Quantity::Core => "awaits.core",
        Quantity::Top => "awaits.top",
        Quantity::Bottom => "awaits.bottom",
        Quantity::Mass => "awaits.mass",
    };
    let (temperature, grams) = (settings.temperature(celsius(value)), format!("{:.0}", 1e3 * value));
    l.fill(key, &[("what", &what), ("food", &food), ("temperature", &temperature), ("grams", &grams)])
}

//! The door of recipes: text that is parsed, checked and cooked.

use saute_attack::doors::{Before, CHANGES, Part, STARTS, Way};
use saute_attack::kitchen_files::LIBRARY;
use saute_recipe::{Cook, Recipe};

use super::{hostile, is_taken, names, sound};

/// Time at which a change is due [s]: food is in the pan, or on the board again.
fn due_s(before: Before) -> f64 {
    if before == Before::OnBoard { 8.0 } else { 0.5 }
}

/// A number as TOML writes it: whole ones without a point, as keys of counts require.
fn number(v: f64) -> String {
    match v {
        v if v.is_nan() => "nan".to_owned(),
        v if v.abs() < 1e15 => v.to_string(),
        v => format!("{v:e}"),
    }
}

/// A recipe with a part in its place, which is due where food is somewhere.
fn text(part: Part, v: f64, before: Before) -> String {
    let stated = |text: &str| text.replace('#', &number(v));
    let [mut top, mut pan, mut hob, mut food, mut step] = [const { String::new() }; 5];
    match part {
        Part::Top(text) => top = stated(text),
        Part::Pan(text) => pan = stated(text),
        Part::Hob(text) => hob = format!("[hob]\n{}", stated(text)),
        Part::Food(text) => food = stated(text),
        Part::Step(text) => step = format!("[[step]]\nat_s = {}\n{}", due_s(before), stated(text)),
        Part::Home(_) => {}
    }
    // A key may occur once.
    let unless = |own: &str, key: &str, usual: &str| if own.contains(key) { "" } else { usual }.to_owned();
    pan += &unless(&pan, "initial_c", "\ninitial_c = 180");
    food += &unless(&food, "size_mm", "\nsize_mm = [60, 50, 15]");
    food += &unless(&food, "coarseness", "\ncoarseness = 4");
    let put = if before == Before::Waiting { "" } else { "[[step]]\nput = \"steak\"\n" };
    let rest = if before == Before::OnBoard { "[[step]]\nat_s = 0.5\nrest = \"steak\"\n" } else { "" };
    format!(
        "{top}\n{hob}\n[pan]\n{pan}\n[[food]]\nid = \"steak\"\nkind = \"beef-lean\"\n{food}\n{put}{rest}{step}\n[[step]]\nafter_s = 1.1\nend = true\n"
    )
}

/// Parses a recipe and cooks it to ten ticks after the change; what the kitchen refuses names its line.
fn tried(name: &str, way: &Way<Part>, before: Before) {
    for v in hostile(way.range) {
        let case = format!("recipe: {name} with {v}");
        let recipe = match Recipe::parse(&text(way.write, v, before), "door.toml", &LIBRARY) {
            Ok(recipe) => recipe,
            Err(error) => {
                assert_ne!(is_taken(way.range, v), Some(true), "{case}: {error}");
                names(&error.to_string(), way.named, way.range, &case);
                continue;
            }
        };
        assert_ne!(is_taken(way.range, v), Some(false), "{case} is taken");
        let Ok(mut cook) = Cook::new(recipe, &LIBRARY) else { continue };
        while cook.stopped().is_none() && cook.kitchen.time_s() < due_s(before) + 1.0 {
            if let Err(error) = cook.advance() {
                assert!(error.to_string().contains("door.toml:"), "{case}: {error}");
                break;
            }
        }
        sound(&cook.kitchen, &case);
    }
}

#[test]
fn a_recipe_with_a_bad_number_is_refused_with_its_key_and_range_or_cooks() {
    for change in CHANGES {
        change.recipe.iter().for_each(|way| tried(change.name, way, change.before));
    }
}

#[test]
fn a_start_with_a_bad_number_is_refused_with_its_key_and_range_or_cooks() {
    for start in STARTS.iter().filter(|start| !matches!(start.recipe.write, Part::Home(_))) {
        tried(start.name, &start.recipe, Before::InPan);
    }
}

//! Promises of conditions: two explicit forms, what a bare number means, and that none of them waits for ever.

// A test that unwraps in vain states where.
#![allow(clippy::unwrap_used)]

use saute_kitchen::{Library, kelvin};
use saute_recipe::{Condition, Cook, Recipe, Side, StoppedBy, Summary, Trigger};
use saute_schema::InputError;

/// Returns a recipe with a steak that starts at 40 °C, a pan at 180 °C and one step for each line of keys.
fn with(steps: &[&str]) -> String {
    let head = "max_s = 40\n[pan]\ninitial_c = 180\n[[food]]\nid = \"steak\"\nkind = \"beef-lean\"\n\
                size_mm = [60, 50, 15]\ninitial_c = 40\nmesh = \"2013\"\n";
    steps.iter().fold(head.to_owned(), |text, step| format!("{text}[[step]]\n{step}\n"))
}

fn parse(text: &str) -> Result<Recipe, InputError> {
    Recipe::parse(text, "test.toml", &Library::embedded().unwrap())
}

fn cooked(text: &str) -> Summary {
    let mut cook = Cook::new(parse(text).unwrap(), &Library::embedded().unwrap()).unwrap();
    while cook.stopped().is_none() {
        cook.advance().unwrap();
    }
    cook.summary(0.0)
}

/// Returns the condition of a `when` in text.
fn condition(when: &str) -> Condition {
    let recipe = parse(&with(&["put = \"steak\"", &format!("when = {when}\nend = true")])).unwrap();
    match &recipe.steps[1].trigger {
        Trigger::When(condition) => condition.clone(),
        other => panic!("{other:?}"),
    }
}

/// Returns when a recipe ends after a condition on the steak, and its warnings; none if it has not ended.
fn ends_at(when: &str) -> (Option<f64>, Vec<String>) {
    let summary = cooked(&with(&["put = \"steak\"", &format!("when = {when}\nend = true")]));
    ((summary.stopped_by == StoppedBy::End).then_some(summary.simulated_s), summary.warnings)
}

#[test]
fn every_quantity_has_two_explicit_forms_and_a_plain_one() {
    for (key, number, value, plain) in [
        ("core_c", 52.0, kelvin(52.0), Side::Above),
        ("top_c", 40.0, kelvin(40.0), Side::Above),
        ("bottom_c", 150.0, kelvin(150.0), Side::Above),
        ("mass_g", 30.0, 0.03, Side::Below),
        ("pan_c", 180.0, kelvin(180.0), Side::Above),
    ] {
        let food = if key == "pan_c" { "" } else { "food = \"steak\", " };
        let read = |form: String| {
            let condition = condition(&format!("{{ {food}{key} = {form} }}"));
            assert!((condition.value - value).abs() < 1e-9 && condition.measured.key() == key, "{condition:?}");
            (condition.side, condition.plain)
        };
        assert_eq!(read(format!("{number}")), (plain, true), "{key}");
        assert_eq!(read(format!("{{ above = {number} }}")), (Side::Above, false), "{key}");
        assert_eq!(read(format!("{{ below = {number} }}")), (Side::Below, false), "{key}");
    }
}

#[test]
fn a_condition_that_holds_does_not_wait() {
    for when in [
        "{ food = \"steak\", core_c = { above = 30 } }",
        "{ food = \"steak\", core_c = { below = 45 } }",
        "{ food = \"steak\", core_c = 30 }",
        "{ food = \"steak\", mass_g = 500 }",
        "{ food = \"steak\", mass_g = { above = 5 } }",
        "{ food = \"all\", top_c = { above = 30 } }",
        "{ pan_c = { above = 150 } }",
        "{ pan_c = { below = 200 } }",
        "{ pan_c = 150 }",
    ] {
        assert_eq!(ends_at(when).0, Some(0.0), "{when}");
    }
}

#[test]
fn a_condition_waits_until_its_side_is_reached() {
    let (cooled, warnings) = ends_at("{ pan_c = { below = 170 } }");
    assert!(cooled.is_some_and(|s| s > 0.5) && warnings.is_empty(), "{cooled:?} {warnings:?}");
    let (warm, warnings) = ends_at("{ food = \"steak\", bottom_c = { above = 60 } }");
    assert!(warm.is_some_and(|s| s > 0.05) && warnings.is_empty(), "{warm:?} {warnings:?}");
    assert_eq!(ends_at("{ food = \"steak\", bottom_c = 60 }").0, warm);
    assert_eq!(ends_at("{ food = \"steak\", core_c = { below = 10 } }").0, None, "it never gets so cold");
}

#[test]
fn a_plain_temperature_that_is_passed_warns_with_line_and_remedy() {
    let (ended, warnings) = ends_at("{ food = \"steak\", core_c = 30 }");
    assert_eq!((ended, warnings.len()), (Some(0.0), 1), "{warnings:?}");
    for part in ["line 12", "core_c = 30", "{ below = 30 }", "{ above = 30 }"] {
        assert!(warnings[0].contains(part), "{part}: {}", warnings[0]);
    }
    // A mass falls, and the explicit forms leave no doubt.
    for when in [
        "{ food = \"steak\", mass_g = 500 }",
        "{ food = \"steak\", core_c = { above = 30 } }",
        "{ pan_c = { above = 150 } }",
    ] {
        assert_eq!(ends_at(when).1, Vec::<String>::new(), "{when}");
    }
}

#[test]
fn the_next_step_says_on_which_side_it_waits() {
    let waiting = |when: &str| {
        let recipe = parse(&with(&[&format!("when = {when}\nend = true")])).unwrap();
        Cook::new(recipe, &Library::embedded().unwrap()).unwrap().runner.waiting_for()
    };
    assert_eq!(waiting("{ food = \"steak\", core_c = 52 }"), "end when the core of steak reaches 52 °C");
    assert_eq!(waiting("{ food = \"steak\", top_c = { below = 30 } }"), "end when the top of steak falls to 30 °C");
    assert_eq!(waiting("{ pan_c = { below = 80 } }"), "end when the pan falls to 80 °C");
    assert_eq!(waiting("{ food = \"steak\", mass_g = 40 }"), "end when steak weighs 40 g");
}

#[test]
fn every_mistake_in_a_condition_is_named_with_its_line_and_a_remedy() {
    for (when, says) in [
        (
            "{ food = \"steak\", core_c = { above = 50, below = 60 } }",
            ["core_c has both above and below", "{ above = 50 }"],
        ),
        ("{ food = \"steak\", core_c = {} }", ["core_c has neither above nor below", "{ below = 50 }"]),
        ("{ food = \"steak\", core_c = { over = 50 } }", ["over is no key", "there are: above, below"]),
        ("{ food = \"steak\", core_c = 900 }", ["core_c = 900", "use 0 to 500"]),
        ("{ pan_c = { below = nan } }", ["pan_c.below = NaN", "use 0 to 500"]),
        ("{ food = \"steak\", mass_g = -1 }", ["mass_g = -1", "use 0 to 500000"]),
        ("{ core_c = 50 }", ["when needs one condition", "below"]),
        ("{ pan_c = 50, food = \"steak\", core_c = 50 }", ["when needs one condition", "pan_c = 180"]),
        ("{ food = \"steak\", core_c = \"hot\" }", ["core_c is a text", "a number or a table"]),
    ] {
        let error = parse(&with(&["put = \"steak\"", &format!("when = {when}\nend = true")])).expect_err(when);
        assert!((12..=13).contains(&error.line), "{error}");
        says.iter().for_each(|part| assert!(error.to_string().contains(part), "{part}: {error}"));
    }
}

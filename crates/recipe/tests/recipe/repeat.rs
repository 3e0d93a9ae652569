//! Promises of `repeat`: its rhythm, its end at any tick, its records and its errors.

// A test that unwraps in vain states where.
#![allow(clippy::unwrap_used)]

use saute_kitchen::Library;
use saute_recipe::{Action, Cook, Recipe, RepeatEnd, StoppedBy};
use saute_schema::InputError;

/// Returns a recipe with a steak, a pan at 180 °C and one step for each line of keys.
fn with(steps: &[&str]) -> String {
    let head = "max_s = 100\n[pan]\ninitial_c = 180\n[[food]]\nid = \"steak\"\nkind = \"beef-lean\"\n\
                size_mm = [60, 50, 15]\nmesh = \"2013\"\n";
    steps.iter().fold(head.to_owned(), |text, step| format!("{text}[[step]]\n{step}\n"))
}

fn parse(text: &str) -> Result<Recipe, InputError> {
    Recipe::parse(text, "test.toml", &Library::embedded().unwrap())
}

fn cooked(steps: &[&str]) -> Cook {
    let mut cook = Cook::new(parse(&with(steps)).unwrap(), &Library::embedded().unwrap()).unwrap();
    while cook.stopped().is_none() {
        cook.advance().unwrap();
    }
    cook
}

/// Returns the steps that were carried out, with their times in tenths of a second.
fn records(cook: &Cook) -> Vec<(&'static str, i64)> {
    cook.steps.iter().map(|s| (s.action.name(), (s.time_s * 10.0).round() as i64)).collect()
}

#[test]
fn the_first_repetition_is_one_period_after_the_step_and_each_has_its_record() {
    let cook = cooked(&["put = \"steak\"", "repeat = { flip = \"steak\", every_s = 10, times = 3 }", "end = true"]);
    let flips: Vec<i64> = records(&cook).iter().filter(|(name, _)| *name == "flip").map(|(_, at)| *at).collect();
    assert_eq!(flips, [100, 200, 300]);
    assert!(cook.steps[1].foods == ["steak"] && cook.steps.len() == 5, "{:?}", records(&cook));
    // The same as three steps that are written out.
    let flip = "after_s = 10\nflip = \"steak\"";
    let copied = cooked(&["put = \"steak\"", flip, flip, flip, "end = true"]);
    assert_eq!(records(&cook), records(&copied));
    assert_eq!(cook.kitchen.pieces()[0].core().to_bits(), copied.kitchen.pieces()[0].core().to_bits());
}

#[test]
fn the_condition_ends_it_between_two_repetitions() {
    let until = "repeat = { flip = \"steak\", every_s = 20, until = { food = \"steak\", bottom_c = { above = 60 } } }";
    let cook = cooked(&["put = \"steak\"", "hob_w = 1000", until, "rest = \"steak\"", "end = true"]);
    let all = records(&cook);
    let met = all.iter().find(|(name, _)| *name == "rest").unwrap().1;
    let (alone, _) = {
        let when = "when = { food = \"steak\", bottom_c = { above = 60 } }\nrest = \"steak\"";
        let cook = cooked(&["put = \"steak\"", "hob_w = 1000", when, "end = true"]);
        (records(&cook)[2].1, cook)
    };
    assert_eq!(met, alone, "it is looked at at every tick");
    assert!(met < 200 && all.iter().all(|(name, _)| *name != "flip"), "{all:?}");
}

#[test]
fn a_condition_that_holds_from_the_start_repeats_nothing() {
    let until = "repeat = { flip = \"steak\", every_s = 5, until = { pan_c = 100 } }";
    let cook = cooked(&["put = \"steak\"", until, "end = true"]);
    assert_eq!(records(&cook), [("put", 0), ("end", 0)]);
}

#[test]
fn an_action_that_takes_longer_than_the_period_is_finished_first() {
    let press = "repeat = { press = { food = \"steak\", n = 5, for_s = 6 }, every_s = 2, times = 2 }";
    let cook = cooked(&["put = \"steak\"", press, "end = true"]);
    let all = records(&cook);
    assert_eq!(all.iter().map(|(name, _)| *name).collect::<Vec<_>>(), ["put", "press", "press", "end"]);
    assert!(all[2].1 - all[1].1 >= 60 && all[3].1 - all[2].1 >= 60, "{all:?}");
}

#[test]
fn the_pan_and_the_hob_can_be_repeated_too() {
    let cook = cooked(&["repeat = { water_g = 5, every_s = 3, times = 2 }", "end = true"]);
    assert_eq!(records(&cook), [("water_g", 30), ("water_g", 60), ("end", 60)]);
}

#[test]
fn max_s_stops_a_repetition_that_does_not_end_and_the_runner_says_what_it_waits_for() {
    let until = "repeat = { flip = \"steak\", every_s = 30, until = { food = \"steak\", core_c = 300 } }";
    let cook = cooked(&["put = \"steak\"", until, "end = true"]);
    assert_eq!((cook.stopped(), cook.kitchen.time_s().round()), (Some(StoppedBy::MaxS), 100.0));
    assert_eq!(cook.runner.waiting_for(), "flip steak at 120 s, until the core of steak reaches 300 °C");
    assert_eq!(cook.summary(0.0).waiting_step, Some(2));
    let recipe = parse(&with(&["put = \"steak\"", &format!("after_s = 9\n{until}"), "end = true"])).unwrap();
    let mut cook = Cook::new(recipe, &Library::embedded().unwrap()).unwrap();
    cook.advance().unwrap();
    assert_eq!(cook.runner.waiting_for(), "repeat flip steak at 9 s");
}

#[test]
fn a_repeat_has_words_and_a_value_in_the_units_of_the_recipe() {
    let text = "repeat = { flip = \"steak\", every_s = 30, until = { food = \"steak\", core_c = 49.5 } }";
    let action = parse(&with(&["put = \"steak\"", text, "end = true"])).unwrap().steps[1].action.clone();
    let Action::Repeat(repeat) = &action else { panic!("{action:?}") };
    assert!(matches!(repeat.end, RepeatEnd::Until(_)));
    assert_eq!(action.words(), "repeat flip steak every 30 s until the core of steak reaches 50 °C");
    let value = action.value();
    assert_eq!((&value["action"], &value["target"]), (&"flip".into(), &"steak".into()));
    assert_eq!((&value["every_s"], &value["until"]["core_c"]["above"]), (&30.0.into(), &49.5.into()));
}

#[test]
fn every_mistake_in_a_repeat_is_named_with_its_line_and_a_remedy() {
    for (table, says) in [
        ("{ flip = \"steak\", every_s = 30 }", ["neither until nor times", "times = 8"]),
        ("{ flip = \"steak\", every_s = 30, times = 3, until = { pan_c = 99 } }", ["both until and times", "keep one"]),
        ("{ flip = \"steak\", times = 3 }", ["repeat.every_s is missing", "write every_s ="]),
        ("{ flip = \"steak\", every_s = 0, times = 3 }", ["repeat.every_s = 0", "0.1 to 3600"]),
        ("{ flip = \"steak\", every_s = -1, times = 3 }", ["repeat.every_s = -1", "0.1 to 3600"]),
        ("{ flip = \"steak\", every_s = 3601, times = 3 }", ["repeat.every_s = 3601", "0.1 to 3600"]),
        ("{ flip = \"steak\", every_s = 30, times = 0 }", ["repeat.times = 0", "1 to 1000"]),
        ("{ flip = \"steak\", every_s = 30, times = 1001 }", ["repeat.times = 1001", "1 to 1000"]),
        ("{ flip = \"steak\", every_s = 30, times = 1.5 }", ["times is a number", "a whole number"]),
        ("{ every_s = 30, times = 3 }", ["repeat has no action", "hob_w, put, flip"]),
        ("{ flip = \"steak\", toss = true, every_s = 30, times = 3 }", ["more than one action", "keep one"]),
        ("{ fry = \"steak\", every_s = 30, times = 3 }", ["repeat.fry is no key", "every_s"]),
        ("{ end = true, every_s = 30, times = 3 }", ["repeat.end is no key", "there are: "]),
        (
            "{ repeat = { flip = \"steak\", every_s = 3, times = 2 }, every_s = 9, times = 2 }",
            ["repeat.repeat is no key", "there are: "],
        ),
        ("{ flip = \"chop\", every_s = 30, times = 3 }", ["flip = \"chop\" names no food", "steak"]),
        ("{ rest = \"steak\", every_s = 30, times = 3 }", ["is not in the pan at this step", "put it into the pan"]),
        (
            "{ flip = \"steak\", every_s = 30, until = { core_c = 50 } }",
            ["until needs one condition", "until = { pan_c"],
        ),
        ("5", ["repeat is a number", "a table"]),
    ] {
        let error = parse(&with(&["put = \"steak\"", &format!("repeat = {table}"), "end = true"])).expect_err(table);
        assert!((10..=12).contains(&error.line), "{error}");
        says.iter().for_each(|part| assert!(error.to_string().contains(part), "{table}: {part}: {error}"));
    }
}

//! Promise: a recipe chooses its stove; what that stove cannot do is refused at its line, and sessions keep the stove.

use saute_kitchen::{Kitchen, Library, celsius};
use saute_recipe::{Cook, Recipe, Recording, Replay};
use saute_schema::InputError;

const STEAK: &str = r#"
[hob]
kind = "STOVE"
[[food]]
id = "steak"
kind = "beef-lean"
size_mm = [70, 60, 20]
mesh = "2013"
[[step]]
hob_w = POWER
[[step]]
when = { pan_c = 180 }
put = "steak"
[[step]]
after_s = 120
flip = "steak"
[[step]]
after_s = 120
rest = "steak"
[[step]]
end = true
"#;

fn text(stove: &str, power: &str) -> String {
    STEAK.replace("STOVE", stove).replace("POWER", power)
}

fn library() -> Library {
    Library::embedded().expect("embedded data")
}

fn parsed(text: &str, library: &Library) -> Result<Recipe, InputError> {
    Recipe::parse(text, "steak.toml", library)
}

fn cooked(text: &str, library: &Library) -> Cook {
    let mut cook = Cook::new(parsed(text, library).expect("parses"), library).expect("builds");
    while cook.stopped().is_none() {
        cook.advance().expect("carried out");
    }
    cook
}

#[test]
fn a_steak_is_fried_on_every_stove_and_is_the_hotter_the_more_the_stove_gives() {
    let library = library();
    // Powers from low to high, of which about the same reaches the pan.
    for (stove, powers) in [
        ("induction", ["700", "1000", "1400"]),
        ("gas", ["1500", "2000", "2800"]),
        ("radiant", ["1000", "1400", "1800"]),
        ("iron-plate", ["850", "1150", "2000"]),
    ] {
        let cores = powers.map(|power| {
            let cook = cooked(&text(stove, power), &library);
            let steak = &cook.kitchen.pieces()[0];
            println!("{stove} {power} W: {:.1} °C", celsius(steak.core_peak.0));
            celsius(steak.core_peak.0)
        });
        assert!(cores.is_sorted() && cores[0] > 25.0 && cores[2] < 75.0, "{stove}: {cores:?}");
    }
}

#[test]
fn what_a_stove_cannot_do_is_refused_with_place_and_remedy() {
    let library = library();
    let refused = |text: &str| {
        let error = parsed(text, &library).expect_err("refused");
        (error.line, error.message, error.remedy)
    };
    let (line, message, remedy) = refused(&text("campfire", "1000"));
    assert_eq!((line, message.as_str()), (3, "hob.kind = \"campfire\" is not a hob"));
    assert_eq!(remedy, "use one of: gas, induction, iron-plate, radiant");
    let (line, message, remedy) = refused(&text("iron-plate", "1000"));
    assert_eq!((line, message.as_str()), (10, "hob_w = 1000: the hob \"Iron hot plate\" does not give this power"));
    assert_eq!(remedy, "write hob_w = 850; its settings are 0, 175, 220, 300, 850, 1150, 2000 W");
    let (_, message, remedy) = refused(&text("gas", "250"));
    assert!(message.contains("does not give") && remedy.starts_with("write hob_w = 400"), "{message}\n{remedy}");
    let (_, message, _) = refused(&text("radiant", "2000"));
    assert_eq!(message, "hob_w = 2000 is out of range");
    let (line, message, remedy) = refused(&text("gas", "{ hold_c = 200, w = 2000 }"));
    assert_eq!(
        (line, message.as_str()),
        (10, "hob_w.hold_c: the hob \"Gas burner\" has no sensor and holds no temperature")
    );
    assert!(remedy.contains("[hob] kind = \"induction\""), "{remedy}");
}

#[test]
fn a_recipe_without_a_stove_is_cooked_on_that_of_the_kitchen_at_home() {
    let home = library().on_hob("iron-plate").expect("a plate").into_owned();
    let plain = text("STOVE", "1000").replace("[hob]\nkind = \"STOVE\"\n", "");
    let cook = Cook::new(parsed(&plain, &home).expect("its switch takes the nearest step"), &home).expect("builds");
    assert_eq!(cook.kitchen.hob().name, "Iron hot plate");
    let named = Cook::new(parsed(&text("gas", "1500"), &home).expect("parses"), &home).expect("builds");
    assert_eq!(named.kitchen.hob().name, "Gas burner");
}

#[test]
fn a_session_on_gas_is_replayed_on_gas_and_its_recipe_names_it() {
    let library = library();
    let recipe = parsed(&text("gas", "2000"), &library).expect("parses");
    let mut recording = Recording::begin(&recipe, true, &library);
    let mut live = Replay::begin(&recording, &library).expect("begins");
    for _ in 0..1200 {
        let Replay { kitchen, runner, .. } = &mut live;
        if kitchen.is_between_ticks() {
            runner.poll(kitchen).expect("carried out");
            recording.on_steps(kitchen);
        }
        kitchen.advance_frame();
        recording.observe(kitchen);
    }
    let opened = Recording::from_file(&recording.to_file()).expect("a session").recording;
    assert_eq!(opened.beginning().difference(&recipe, &library), None);
    let mut again = Replay::begin(&opened, &library).expect("begins");
    again.run_to(&opened, &library, opened.moment());
    assert_eq!(again.kitchen.hob().name, "Gas burner");
    assert!(again.departure().is_none() && again.kitchen.state_hash() == live.kitchen.state_hash());
    let stored = Kitchen::from_bytes(&again.kitchen.to_bytes(), &library).expect("a kitchen");
    assert_eq!(stored.hob().name, "Gas burner");
    assert_eq!(stored.state_hash(), again.kitchen.state_hash());
}

/// A recipe has the oil that it states, or the usual 5 g; its summary states which.
#[test]
fn the_summary_says_with_which_oil_a_cook_began() {
    let library = library();
    let begun = |pan: &str, step: &str| {
        let text = format!(
            "[pan]\ninitial_c = 180\n{pan}\n[[food]]\nid = \"coin\"\nkind = \"carrot-coin\"\nmesh = \"2013\"\n{step}\n[[step]]\nput = \"coin\"\n\
             [[step]]\nbutter_g = 5\n[[step]]\nafter_s = 1\nend = true\n"
        );
        let cook = cooked(&text, &library);
        let summary = cook.summary(0.0);
        (summary.oil_at_start.g, summary.oil_at_start.stated, summary.liquids_g.oil)
    };
    assert_eq!(begun("", "").0, 5.0);
    assert!(!begun("", "").1, "butter that follows the food says nothing of the start");
    assert_eq!((begun("oil_g = 0", "").0, begun("oil_g = 0", "").1), (0.3, true));
    assert_eq!((begun("oil_g = 12", "").0, begun("oil_g = 12", "").1), (12.0, true));
    let (start, stated, end) = begun("", "[[step]]\noil_g = 8");
    assert!((start, stated) == (0.3, true) && (8.0..8.4).contains(&end), "{start} {end}");
    assert_eq!(begun("oil_g = 2", "[[step]]\noil_g = 8").0, 2.0);
    let wrong = "[pan]\noil_g = -1\n[[step]]\nend = true\n";
    let error = parsed(wrong, &library).expect_err("refused");
    assert_eq!((error.line, error.message.as_str()), (2, "pan.oil_g = -1 is out of range"));
    let wiped = parsed("[[step]]\nwipe = true\n[[step]]\nend = true\n", &library).expect("parses");
    assert_eq!(wiped.steps[0].action.words(), "wipe the pan");
    let error = parsed("[[step]]\nwipe = false\n[[step]]\nend = true\n", &library).expect_err("refused");
    assert_eq!(error.message, "wipe = false does nothing");
}

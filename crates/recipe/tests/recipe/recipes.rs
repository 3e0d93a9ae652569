//! Promises of the recipe format: defaults of every action, groups, conditions on groups, and errors.

// A test that unwraps in vain states where.
#![allow(clippy::unwrap_used)]

use saute_kitchen::food::Rules;
use saute_kitchen::{Command, Library, MeshSize, RestOn, kelvin};
use saute_recipe::recipe::Quantity;
use saute_recipe::recipe_file::RecipeFile;
use saute_recipe::summary::FoodSummary;
use saute_recipe::{Action, Cook, FoodAction, Measured, PanAction, Recipe, StoppedBy, Trigger};
use saute_schema::InputError;
use serde_json::Value;

/// A steak and eleven carrots; the tests add steps.
const FOODS: &str = r#"[pan]
initial_c = 180
[[food]]
id = "steak"
kind = "beef-lean"
size_mm = [60, 50, 15]
[[food]]
id = "carrots"
kind = "carrot-coin"
size_mm = [25, 6]
count = 11
seed = 5
"#;

/// Returns a recipe with one step for each line of keys.
fn with(steps: &[&str]) -> String {
    steps.iter().fold(FOODS.to_owned(), |text, step| format!("{text}[[step]]\n{step}\n"))
}

fn parse(text: &str) -> Result<Recipe, InputError> {
    Recipe::parse(text, "test.toml", &Library::embedded().unwrap())
}

/// Returns the action of a line, in a recipe that puts all foods into the pan before it.
fn action(line: &str) -> Action {
    let before = if line.starts_with("halve") { "rest = \"steak\"" } else { "hob_w = 0" };
    let text = with(&["put = \"steak\"", "put = \"carrots\"", before, line, "end = true"]);
    parse(&text).unwrap_or_else(|e| panic!("{line}: {e}")).steps[3].action.clone()
}

fn command(line: &str) -> Command {
    match action(line) {
        Action::Pan(action) => action.command(),
        other => panic!("{line}: {other:?}"),
    }
}

/// Returns the name of the target, the number of its foods and the action on them.
fn each(line: &str) -> (String, usize, FoodAction) {
    match action(line) {
        Action::Each(target, action) => (target.name, target.foods.len(), action),
        other => panic!("{line}: {other:?}"),
    }
}

#[test]
fn a_bare_value_takes_the_defaults_of_the_table() {
    for (bare, table) in [
        ("hob_w = 800", "hob_w = { w = 800 }"),
        ("move_pan = true", "move_pan = { at_mm = [0, 0], lift_mm = 0 }"),
        ("cool = \"wet-cloth\"", "cool = { by = \"wet-cloth\", for_s = 3 }"),
        ("oil_g = 10", "oil_g = { g = 10 }"),
        ("butter_g = 15", "butter_g = { g = 15 }"),
        ("water_g = 30", "water_g = { g = 30 }"),
        ("toss = true", "toss = { height_mm = 250 }"),
        ("shake = 7", "shake = { amplitude_mm = 20, hz = 3, for_s = 7 }"),
        ("shake = {}", "shake = 5"),
        ("tilt = 15", "tilt = { deg = 15, towards_deg = 0 }"),
        ("press = \"steak\"", "press = { food = \"steak\", n = 10, for_s = 5 }"),
        ("move = \"steak\"", "move = { food = \"steak\", to_mm = [0, 0] }"),
        ("flip = \"steak\"", "flip = { food = \"steak\" }"),
        ("rest = \"steak\"", "rest = { food = \"steak\", on = \"board\" }"),
        ("halve = \"steak\"", "halve = { food = \"steak\", at_mm = 0 }"),
        ("lid = true", "lid = { on = \"on\" }"),
        ("lid = \"off\"", "lid = { on = false }"),
    ] {
        assert_eq!(action(bare), action(table), "{bare}");
    }
    let put = |line: &str| parse(&with(&[line, "end = true"])).unwrap().steps[0].action.clone();
    assert_eq!(put("put = \"steak\""), put("put = { food = \"steak\", at_mm = [0, 0], heap = false }"));
}

#[test]
fn actions_arrive_in_si_units() {
    assert_eq!(
        command("oil_g = { g = 10, kind = \"canola\" }"),
        Command::Oil { kind: Some("canola".into()), mass: 0.01 }
    );
    assert_eq!(
        command("hob_w = { hold_c = 180, w = 2000 }"),
        Command::HobHold { temperature: kelvin(180.0), power: 2000.0 }
    );
    assert_eq!(action("hob_w = { hold_c = 180, w = 2000 }").words(), "hob holds 180 °C with up to 2000 W");
    assert_eq!(action("hob_w = { hold_c = 180, w = 2000 }").value()["hold_c"], 180.0);
    assert_eq!(command("butter_g = 15"), Command::Butter(0.015));
    assert_eq!(command("water_g = 30"), Command::Water(0.03));
    assert_eq!(command("toss = { height_mm = 200 }"), Command::Toss { height: 0.2 });
    assert_eq!(
        command("shake = { amplitude_mm = 50, hz = 2, for_s = 4 }"),
        Command::Shake { amplitude: 0.05, hz: 2.0, for_s: 4.0 }
    );
    let quarter = core::f64::consts::FRAC_PI_2;
    assert_eq!(
        command("tilt = { deg = 45, towards_deg = 90 }"),
        Command::Tilt { angle: quarter / 2.0, towards: quarter }
    );
    assert_eq!(command("lid = \"on\""), Command::Lid(true));
    assert_eq!(
        each("press = { food = \"carrots\", n = 20, for_s = 2 }"),
        ("carrots".into(), 11, FoodAction::Press { newtons: 20.0, for_s: 2.0 })
    );
    assert_eq!(
        each("move = { food = \"steak\", to_mm = [30, -10] }"),
        ("steak".into(), 1, FoodAction::Move([0.03, -0.01]))
    );
    assert_eq!(each("flip = \"all\""), ("all".into(), 12, FoodAction::Flip));
    assert_eq!(
        each("rest = { food = \"carrots.3\", on = \"rack\" }"),
        ("carrots.3".into(), 1, FoodAction::Rest(RestOn::Rack))
    );
}

/// Returns a step with an action's table: its required keys and one more.
fn table(action: &str, needs: &[&str], key: &str, value: &Value) -> String {
    let own = |name: &str| match name {
        "food" => "\"steak\"",
        "by" => "\"wet-cloth\"",
        "on" => "true",
        _ => "10",
    };
    let others = needs.iter().filter(|n| **n != key).map(|n| format!("{n} = {}", own(n)));
    let keys: Vec<String> = others.chain((!key.is_empty()).then(|| format!("{key} = {value}"))).collect();
    format!("{action} = {{ {} }}", keys.join(", "))
}

/// Returns the action of such a table, or its error.
fn action_of_table(line: &str) -> Result<Action, InputError> {
    let first = if line.starts_with("put") { "hob_w = 0" } else { "put = \"steak\"" };
    let second = if line.starts_with("halve") { "rest = \"steak\"" } else { "hob_w = 0" };
    parse(&with(&[first, second, line, "end = true"])).map(|recipe| recipe.steps[2].action.clone())
}

/// Returns every action with its table in the schema.
fn tables() -> Vec<(String, Value)> {
    let schema = serde_json::to_value(schemars::schema_for!(RecipeFile)).unwrap();
    let properties = schema["$defs"]["StepEntry"]["properties"].as_object().unwrap();
    let is_table =
        |path: &&str| schema.pointer(path.trim_start_matches('#')).is_some_and(|t| t["properties"].is_object());
    let table = |(action, of): (&String, &Value)| {
        // Its table has the keys of all actions; tests/repeat.rs is about it.
        if action == "repeat" {
            return None;
        }
        let alternatives =
            of["anyOf"].as_array().filter(|_| of["description"].as_str().unwrap().starts_with("Action: "))?;
        let flat = alternatives.iter().flat_map(|a| a["anyOf"].as_array().into_iter().flatten().chain([a]));
        let path = flat.filter_map(|a| a["$ref"].as_str()).find(is_table)?;
        Some((action.clone(), schema.pointer(path.trim_start_matches('#'))?.clone()))
    };
    properties.iter().filter_map(table).collect()
}

/// The schema's ranges are those that are checked, and its defaults are the values of omitted keys.
#[test]
fn ranges_and_defaults_of_the_schema_are_those_that_are_checked() {
    let (mut ranges, mut defaults) = (0, 0);
    for (action, table_schema) in tables() {
        let needs: Vec<&str> =
            table_schema["required"].as_array().into_iter().flatten().filter_map(Value::as_str).collect();
        for (key, of) in table_schema["properties"].as_object().unwrap() {
            let with_value = |value: f64| action_of_table(&table(&action, &needs, key, &value.into()));
            if let Some((low, high)) = of["minimum"].as_f64().zip(of["maximum"].as_f64()) {
                ranges += 1;
                assert!(with_value(low).is_ok() && with_value(high).is_ok(), "{action}.{key}");
                for beyond in [low - 0.01, high + 0.01] {
                    let error = with_value(beyond).expect_err("is refused");
                    assert!(error.message.contains("is out of range"), "{action}.{key}: {error}");
                }
            }
            if let Some(default) = of.get("default") {
                defaults += 1;
                let bare = action_of_table(&table(&action, &needs, "", &Value::Null)).unwrap();
                assert_eq!(action_of_table(&table(&action, &needs, key, default)).unwrap(), bare, "{action}.{key}");
            }
        }
    }
    assert_eq!((ranges, defaults), (17, 16));
}

/// `at_mm`, `on` and `for_s` are accepted next to a bare value, too.
#[test]
fn companions_are_next_to_a_bare_value_or_in_its_table() {
    let steps =
        ["put = \"steak\"\nat_mm = [10, 0]", "rest = \"steak\"\non = \"foil\"", "cool = \"wet-cloth\"\nfor_s = 9"];
    let recipe = parse(&with(&[steps[0], steps[1], steps[2], "end = true"])).unwrap();
    let food_action = |i: usize| match &recipe.steps[i].action {
        Action::Each(_, action) => *action,
        other => panic!("{other:?}"),
    };
    assert_eq!(food_action(0), FoodAction::Put { at: [0.01, 0.0], heap: false });
    assert_eq!(food_action(1), FoodAction::Rest(RestOn::Foil));
    assert_eq!(recipe.steps[2].action, Action::Pan(PanAction::Cool { for_s: 9.0 }));
}

#[test]
fn a_group_is_as_many_pieces_with_seeds_that_follow_each_other() {
    let recipe = parse(&with(&["end = true"])).unwrap();
    assert_eq!(recipe.foods.len(), 12);
    assert_eq!((recipe.foods[0].id.as_str(), recipe.foods[0].seed), ("steak", 1));
    for i in 1..=11 {
        let food = &recipe.foods[i];
        assert_eq!((food.id.clone(), food.seed), (format!("carrots.{i}"), 4 + i as u64));
        assert_eq!((food.size, food.rules), ([0.025, 0.025, 0.006], Rules::Full));
    }
    let group = &recipe.groups[0];
    assert_eq!((group.id.as_str(), group.kind.as_str(), group.members.clone()), ("carrots", "carrot-coin", 1..12));
    assert_eq!(recipe.groups.len(), 1);
}

#[test]
fn one_piece_is_a_group_if_it_is_counted_and_the_mesh_is_chosen_by_food() {
    let text = with(&["end = true"]).replace("count = 11", "count = 1\nmesh = \"2013\"");
    let recipe = parse(&text).unwrap();
    assert_eq!(recipe.foods[1].id, "carrots.1");
    assert_eq!(recipe.groups[0].members, 1..2);
    assert_eq!((recipe.foods[0].mesh, recipe.foods[1].mesh), (MeshSize::Default, MeshSize::Paper2013));
}

#[test]
fn a_condition_on_a_group_concerns_each_of_its_pieces() {
    let recipe = parse(&with(&["when = { food = \"carrots\", core_c = 60 }\nend = true"])).unwrap();
    let Trigger::When(condition) = &recipe.steps[0].trigger else { panic!("{:?}", recipe.steps) };
    let Measured::Food { food, quantity } = &condition.measured else { panic!("{condition:?}") };
    assert_eq!((food.foods.len(), *quantity, condition.value), (11, Quantity::Core, kelvin(60.0)));
}

/// An invalid line of a recipe, and parts of its message and remedy.
struct Wrong(&'static str, &'static [&'static str]);

const WRONG_STEPS: [Wrong; 43] = [
    Wrong("oil_g = -1", &["oil_g = -1", "0 to 300"]),
    Wrong("oil_g = { g = 10, king = \"canola\" }", &["oil_g.king is no key", "write kind"]),
    Wrong("oil_g = { kind = \"canola\" }", &["oil_g.g is missing", "write g ="]),
    Wrong("oil_g = \"much\"", &["oil_g is a text", "a number or a table"]),
    Wrong("butter_g = 301", &["butter_g = 301", "0 to 300"]),
    Wrong("butter_g = nan", &["butter_g = NaN", "0 to 300"]),
    Wrong("water_g = -5", &["water_g = -5", "0 to 1000"]),
    Wrong("toss = false", &["toss", "does nothing", "write true"]),
    Wrong("toss = { height_mm = 5 }", &["toss.height_mm = 5", "50 to 500"]),
    Wrong("toss = { height = 5 }", &["toss.height is no key", "height_mm"]),
    Wrong("toss = 5", &["toss is a number", "true or false or a table"]),
    Wrong("shake = { amplitude_mm = 101 }", &["shake.amplitude_mm = 101", "0 to 100"]),
    Wrong("shake = { hz = 9 }", &["shake.hz = 9", "0 to 8"]),
    Wrong("shake = 0", &["shake = 0", "0.1 to 600"]),
    Wrong("shake = { hertz = 3 }", &["shake.hertz is no key", "amplitude_mm, for_s, hz"]),
    Wrong("tilt = 81", &["tilt = 81", "0 to 80"]),
    Wrong("tilt = { deg = 10, towards_deg = 400 }", &["tilt.towards_deg = 400", "-360 to 360"]),
    Wrong("press = { food = \"steak\", n = -1 }", &["press.n = -1", "0 to 100"]),
    Wrong("press = { n = 5 }", &["press.food is missing", "write food ="]),
    Wrong(
        "press = { food = \"chop\" }",
        &["press = \"chop\"", "names no food", "steak, carrots (carrots.1 to carrots.11); or all"],
    ),
    Wrong("move = { food = \"steak\", to_mm = [30] }", &["move.to_mm", "to_mm = [x, y]"]),
    Wrong("move = { food = \"steak\", to_mm = [300, 0] }", &["move.to_mm = 300", "-200 to 200"]),
    Wrong("lid = \"up\"", &["lid = \"up\" is unknown", "use one of: on, off"]),
    Wrong("flip = \"carrots.12\"", &["flip = \"carrots.12\"", "names no food", "carrots.1 to carrots.11"]),
    Wrong("flip = { food = \"steak\", times = 2 }", &["flip.times is no key", "there are: food"]),
    Wrong("flip = [\"steak\"]", &["flip is a list", "a text or a table"]),
    Wrong("put = \"steak\"", &["\"steak\" is in the pan already", "rest it first"]),
    Wrong("put = \"all\"", &["\"all\" is in the pan already"]),
    Wrong("put = { food = \"steak\" }\nat_mm = [0, 0]", &["at_mm stands beside the table of put", "put = {"]),
    Wrong("cool = { by = \"wet-cloth\" }\nfor_s = 3", &["for_s stands beside the table of cool"]),
    Wrong("rest = { food = \"steak\" }\non = \"rack\"", &["on stands beside the table of rest"]),
    Wrong("press = \"steak\"\nfor_s = 3", &["for_s has no cool beside it", "own table"]),
    Wrong("at_mm = [0, 0]\nflip = \"steak\"", &["at_mm has no put beside it"]),
    Wrong("cool = \"ice\"", &["cool = \"ice\" is unknown", "wet-cloth"]),
    Wrong("move_pan = { lift_mm = 501 }", &["move_pan.lift_mm = 501", "0 to 500"]),
    Wrong("move_pan = { at_mm = [0, 400] }", &["move_pan.at_mm = 400", "-350 to 350"]),
    Wrong("move_pan = false", &["move_pan", "does nothing"]),
    Wrong("hob_w = { hold_c = 180, w = 9000 }", &["hob_w.w = 9000", "0 to 3500"]),
    Wrong("hob_w = { hold_c = 260, w = 2000 }", &["hob_w.hold_c = 260", "50 to 230"]),
    Wrong("hob_w = { hold_c = 180 }", &["hob_w.w is missing", "write w ="]),
    Wrong("hob_w = { w = 9000 }", &["hob_w.w = 9000", "0 to 3500"]),
    Wrong("lid = true\ntoss = true", &["more than one action"]),
    Wrong("when = { food = \"leeks\", core_c = 60 }\nlid = true", &["when.food = \"leeks\"", "names no food"]),
];

#[test]
fn every_mistake_in_an_action_is_named_with_its_line_and_a_remedy() {
    let before = with(&["put = \"steak\"", "put = \"carrots\""]).lines().count();
    for Wrong(line, says) in WRONG_STEPS {
        let error = parse(&with(&["put = \"steak\"", "put = \"carrots\"", line, "end = true"])).expect_err(line);
        // The step's header, or one of its lines.
        assert!((before + 1..=before + 3).contains(&error.line), "{line}: {error}");
        for part in says {
            assert!(error.to_string().contains(part), "{line}: {part}:\n{error}");
        }
    }
}

#[test]
fn every_mistake_in_a_food_is_named_with_its_line_and_a_remedy() {
    for (from, to, line, says) in [
        ("count = 11", "count = 0", 11, ["count = 0", "1 to 100"]),
        ("count = 11", "count = -3", 11, ["count = -3", "1 to 100"]),
        ("count = 11", "count = 5000", 11, ["count = 5000", "1 to 100"]),
        ("count = 11", "count = 1.5", 11, ["count is a number", "a whole number"]),
        ("count = 11", "mesh = \"2012\"", 11, ["2012", "write \"2013\""]),
        ("\"carrots\"", "\"carrots.1\"", 8, ["carrots.1", "letters, digits"]),
        ("\"carrots\"", "\"all\"", 8, ["stands for all foods", "another id"]),
        ("\"carrots\"", "\"steak\"", 8, ["used twice", "its own id"]),
    ] {
        let text = with(&["end = true"]);
        assert!(text.contains(from));
        let error = parse(&text.replacen(from, to, 1)).expect_err(to);
        assert_eq!(error.line, line, "{error}");
        says.iter().for_each(|part| assert!(error.to_string().contains(part), "{part}: {error}"));
    }
}

#[test]
fn pieces_that_need_too_much_memory_are_refused_before_one_is_built_with_the_number_that_fits() {
    let asked = |count: usize, coarseness: f64| {
        let text = format!(
            "[[food]]\nid = \"g\"\nkind = \"beef-lean\"\nsize_mm = [190, 190, 60]\ncoarseness = {coarseness}\ncount = {count}\n[[step]]\nend = true\n"
        );
        parse(&text)
    };
    let error = asked(90, 1.0).expect_err("90 steaks of two kilograms");
    assert_eq!(error.line, 6);
    assert!(error.message.starts_with("food \"g\": 90 pieces of this size need about 3."), "{error}");
    let fit = error.remedy.strip_prefix("write count = ").and_then(|rest| rest.split_once(',')).expect("a number").0;
    let fit: usize = fit.parse().expect("a number");
    assert!(error.message.contains(&format!("at most {fit} fit")), "{error}");
    assert!(asked(fit, 1.0).is_ok() && asked(fit + 1, 1.0).is_err());
    assert!(asked(fit + 1, 2.0).is_ok(), "the second remedy holds, too");
}

#[test]
fn a_group_that_cannot_lie_in_the_pan_is_refused_before_it_is_built() {
    let text = |put: &str| {
        format!(
            "[[food]]\nid = \"g\"\nkind = \"carrot-coin\"\nsize_mm = [60, 3]\ncount = 90\n[[step]]\nput = {put}\n[[step]]\nend = true\n"
        )
    };
    let error = parse(&text("\"g\"")).expect_err("three pans of carrots");
    assert!(error.line == 6 || error.line == 7, "{error}");
    assert!(error.message.starts_with("not all of \"g\" find room on the floor of the pan: at most"), "{error}");
    assert!(error.remedy.contains("heap = true"), "{error}");
    assert!(parse(&text("{ food = \"g\", heap = true }")).is_ok());
}

#[test]
fn what_is_not_in_the_pan_at_a_step_is_found_before_the_cook() {
    for (steps, says) in [
        (vec!["toss = true"], "nothing in the pan to toss"),
        (vec!["put = \"steak\"", "rest = \"steak\"", "toss = true"], "nothing in the pan to toss"),
        (vec!["put = \"steak\"", "flip = \"carrots\""], "\"carrots\" is not in the pan"),
        (vec!["put = \"steak\"", "press = \"carrots.2\""], "\"carrots.2\" is not in the pan"),
        (vec!["move = \"steak\""], "\"steak\" is not in the pan"),
        (vec!["flip = \"all\""], "\"all\" is not in the pan"),
        (vec!["put = \"carrots\"", "rest = \"carrots\"", "rest = \"carrots.1\""], "\"carrots.1\" is not in the pan"),
    ] {
        let mut all = steps.clone();
        all.push("end = true");
        let error = parse(&with(&all)).expect_err("is refused");
        assert!(error.to_string().contains(says), "{error}");
        assert_eq!(error.line, with(&steps).lines().count() - 1, "{error}");
    }
    // Of a group it is enough that one piece can be concerned.
    for steps in [
        vec!["put = \"carrots.1\"", "flip = \"carrots\"", "end = true"],
        vec!["put = \"carrots.1\"", "put = \"carrots\"", "toss = true", "rest = \"all\"", "end = true"],
    ] {
        parse(&with(&steps)).unwrap();
    }
}

fn cook_through(text: &str) -> Result<Cook, InputError> {
    let library = Library::embedded().unwrap();
    let mut cook = Cook::new(parse(text).unwrap(), &library).unwrap();
    while cook.stopped().is_none() {
        cook.advance()?;
    }
    Ok(cook)
}

/// Returns the error of a cook. Its `Debug` text without the error would fill pages.
fn refusal(text: &str) -> InputError {
    cook_through(text).map(|_| ()).expect_err("is refused")
}

#[test]
fn a_group_lies_side_by_side_is_turned_and_taken_out_as_one() {
    let steps = [
        "put = \"carrots\"",
        "after_s = 1\nflip = \"carrots\"",
        "rest = \"carrots.4\"",
        "rest = \"all\"",
        "end = true",
    ];
    let cook = cook_through(&with(&steps)).unwrap();
    let places: Vec<_> = cook.kitchen.pieces().iter().map(|p| (p.id.clone(), p.place.name(), p.up()[2])).collect();
    println!("{places:?}");
    let names: Vec<(&str, usize)> = cook.steps.iter().map(|s| (s.action.name(), s.foods.len())).collect();
    assert_eq!(names, [("put", 11), ("flip", 11), ("rest", 1), ("rest", 10), ("end", 0)]);
    assert_eq!(cook.steps[0].action.target().map(|t| t.name.as_str()), Some("carrots"));
    let pieces = cook.kitchen.pieces();
    assert!(pieces[1..].iter().all(saute_kitchen::Piece::upside_down));
    assert!(!pieces[0].upside_down());
}

/// The group's condition is true when that of its last piece is, not that of its first.
#[test]
fn a_condition_on_a_group_waits_for_its_last_piece() {
    let text = with(&[
        "put = \"carrots\"",
        "rest = \"carrots.7\"",
        "after_s = 20\nput = { food = \"carrots.7\", at_mm = [0, 80] }",
        "hob_w = 600",
        "when = { food = \"carrots.1\", core_c = 45 }\ntilt = 0",
        "end = true",
    ]);
    let text =
        |food: &str| text.replace("\"carrots.1\", core", &format!("\"{food}\", core")).replace("tilt = 0", "hob_w = 0");
    let moment = |food: &str| cook_through(&text(food)).unwrap().steps[4].time_s;
    let (first, late, group) = (moment("carrots.1"), moment("carrots.7"), moment("carrots"));
    assert!(first < late - 1.0, "{first} {late}");
    assert_eq!(group, late);
}

#[test]
fn a_condition_on_all_foods_waits_for_those_that_are_not_cooked_too_and_says_so() {
    let text = with(&["put = \"carrots.1\"", "when = { food = \"all\", bottom_c = 40 }\nend = true"]);
    let cook = cook_through(&format!("max_s = 10\n{text}")).unwrap();
    assert_eq!(cook.stopped(), Some(StoppedBy::MaxS));
    assert_eq!(cook.runner.waiting_for(), "end when the underside of every food reaches 40 °C");
}

#[test]
fn too_many_pieces_are_refused_with_the_number_that_fits() {
    let text = with(&["hob_w = 500", "after_s = 60\nput = \"carrots\"", "end = true"]).replace("[25, 6]", "[60, 6]");
    let error = refusal(&text);
    assert_eq!(error.line, 15, "{error}");
    assert!(error.message.contains("of 11 fit"), "{error}");
    assert!(error.remedy.contains("heap = true"), "{error}");
    let fit: usize = error.message.split(": ").nth(1).unwrap().split(' ').next().unwrap().parse().unwrap();
    // The error comes before the first tick.
    let mut cook = Cook::new(parse(&text).unwrap(), &Library::embedded().unwrap()).unwrap();
    assert_eq!(cook.fire().expect_err("is refused"), error);
    assert_eq!(cook.kitchen.tick(), 0);
    let fewer = text.replace("count = 11", &format!("count = {fit}"));
    cook_through(&fewer).unwrap();
}

/// Foods that lie in the pan at the step count, too.
#[test]
fn a_group_that_does_not_fit_next_to_the_foods_in_the_pan_is_refused_with_the_number_that_fits() {
    let text = with(&["put = \"steak\"", "put = \"carrots\"", "end = true"]).replace("[60, 50, 15]", "[180, 160, 15]");
    let error = refusal(&text);
    assert!(error.message.contains("of 11 fit") && error.line == 15, "{error}");
}

#[test]
fn the_means_of_a_group_are_those_of_its_pieces_and_safety_is_that_of_the_worst() {
    let steps = ["put = \"carrots\"", "after_s = 10\nrest = \"carrots.2\"", "after_s = 30\nend = true"];
    let summary = cook_through(&with(&steps)).unwrap().summary(0.0);
    let group = &summary.groups[0];
    let pieces = &summary.foods[1..];
    assert_eq!((group.count, group.in_pan, group.mean.place), (11, 10, "several"));
    assert_eq!((summary.foods[2].place, summary.foods[0].place), ("board", "waiting"));
    let mean = |of: fn(&FoodSummary) -> f64| pieces.iter().map(of).sum::<f64>() / 11.0;
    let values: [fn(&FoodSummary) -> f64; 7] = [
        |f| f.core_c.end,
        |f| f.core_c.peak,
        |f| f.mass_g.end,
        |f| f.lost_pct,
        |f| f.surfaces.bottom.temperature_c,
        |f| f.denatured["pectin"],
        |f| f.juiciness_pct,
    ];
    for (i, value) in values.into_iter().enumerate() {
        assert!((value(&group.mean) - mean(value)).abs() < 1e-9, "value {i}");
    }
    let cores = pieces.iter().map(|f| f.core_c.end);
    let [low, high] = group.spread.core_end_c;
    assert_eq!((low, high), (cores.clone().fold(f64::MAX, f64::min), cores.fold(f64::MIN, f64::max)));
    assert!(low < high - 1.0, "the piece on the board stayed colder: {low} {high}");
    let worst = pieces.iter().map(|f| f.log_reduction.core).fold(f64::MAX, f64::min);
    assert_eq!(group.mean.log_reduction.core, worst);
}

/// A steak and a group are listed, not eleven pieces.
#[test]
fn a_summary_lists_single_foods_and_groups_in_the_order_of_the_recipe() {
    let summary = cook_through(&with(&["end = true"])).unwrap().summary(0.0);
    let listed: Vec<(&str, usize, bool)> =
        summary.foods_and_groups().iter().map(|t| (t.food.id.as_str(), t.members.len(), t.group)).collect();
    assert_eq!(listed, [("steak", 1, false), ("carrots", 11, true)]);
}

#[test]
fn the_series_has_columns_for_pieces_and_means() {
    let cook = cook_through(&with(&["put = \"carrots\"", "after_s = 5\nend = true"])).unwrap();
    let recipe = cook.runner.recipe();
    let ids: Vec<&str> = recipe.foods.iter().map(|f| f.id.as_str()).collect();
    let csv = cook.recorder.csv(&ids, &recipe.groups).unwrap();
    let head: Vec<&str> = csv.lines().next().unwrap().split(',').collect();
    assert_eq!(head.len(), 3 + 4 * 13);
    assert_eq!(
        (head[3], head[7], head[50], head[51]),
        ("steak.core_c", "carrots.1.core_c", "carrots.11.mass_g", "carrots.core_c")
    );
    let last: Vec<f64> = csv.lines().last().unwrap().split(',').map(|v| v.parse().unwrap()).collect();
    let mean: f64 = (0..11).map(|i| last[7 + 4 * i]).sum::<f64>() / 11.0;
    assert!((last[51] - mean).abs() < 1e-3, "{} {mean}", last[51]);
}

/// Returns the ids of the scales in whose words each food of a short cook is spoken of.
fn words(head: &str, kind: &str) -> Vec<(String, String)> {
    let text = format!(
        "{head}[pan]\ninitial_c = 20\n[[food]]\nid = \"food\"\nkind = \"{kind}\"\ncount = 2\n\
         [[step]]\nafter_s = 1\nend = true\n"
    );
    let summary = cook_through(&text).unwrap().summary(0.0);
    let of = |food: &FoodSummary| -> Vec<(String, String)> {
        food.doneness.0.iter().map(|(id, reading)| (id.clone(), reading.class.clone())).collect()
    };
    assert_eq!(of(&summary.groups[0].mean), of(&summary.foods[0]));
    of(&summary.foods[0])
}

#[test]
fn a_summary_speaks_of_each_food_in_its_own_words_and_by_the_rules_of_2013_also_in_those_of_2013() {
    let of = |expected: &[(&str, &str)]| -> Vec<(String, String)> {
        expected.iter().map(|(id, class)| ((*id).to_owned(), (*class).to_owned())).collect()
    };
    assert_eq!(words("", "shrimp"), of(&[("shrimp", "glassy")]));
    assert_eq!(words("", "carrot-coin"), of(&[("vegetables", "crisp")]));
    assert_eq!(words("", "beef-patty"), of(&[("ground-beef", "raw")]));
    let preset = "preset = \"2013\"\n";
    assert_eq!(words(preset, "shrimp"), of(&[("paper-2013", "raw"), ("shrimp", "glassy")]));
}

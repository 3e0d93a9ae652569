//! `saute list`.

use serde_json::Value;

use crate::cook::cooked::{DISHES, PANTRY, SHIPPED};
use crate::running::run;

fn ids(what: &str) -> Vec<String> {
    let ran = run(&["list", what, "--json"]);
    assert_eq!(ran.code, Some(0));
    let list: Value = serde_json::from_str(&ran.out).unwrap();
    let text = run(&["list", what]).out;
    list.as_array()
        .unwrap()
        .iter()
        .map(|entry| {
            let (id, name) = (entry["id"].as_str().unwrap(), entry["name"].as_str().unwrap());
            assert!(text.lines().any(|l| l.starts_with(id) && l.contains(name)), "{id}, {name}:\n{text}");
            id.to_owned()
        })
        .collect()
}

#[test]
fn the_foods_are_those_of_the_paper_and_of_a_tuesday() {
    let mut expected =
        vec!["beef-lean", "beef-marbled", "beef-patty", "carrot-coin", "carrot-stick", "leek-ring", "shrimp"];
    expected.extend([
        "bacon",
        "chicken-breast",
        "cod-fillet",
        "egg",
        "mushroom-slice",
        "onion-dice",
        "onion-ring",
        "pepper-strip",
        "pork-chop",
        "potato-dice",
        "potato-slice",
        "salmon-fillet",
        "tofu",
    ]);
    expected.sort_unstable();
    assert_eq!(ids("foods"), expected);
}

#[test]
fn every_view_is_listed_with_the_unit_of_its_colours() {
    let expected = ["look", "temperature", "moisture", "doneness", "browning", "lethality", "marbling"];
    assert_eq!(ids("views"), expected);
    let text = run(&["list", "views"]).out;
    assert!(["°C", "% of the raw food's", "log₁₀", "% of the mass"].iter().all(|unit| text.contains(unit)), "{text}");
}

#[test]
fn the_scales_of_doneness_are_listed_with_their_classes_and_sources() {
    let of_the_paper = ["paper-2013", "chefs", "academic", "shrimp", "ground-beef", "vegetables"];
    let of_a_tuesday =
        ["chicken", "pork", "cod", "salmon", "tofu", "potato", "egg", "onion", "pepper", "bacon", "mushroom"];
    assert_eq!(ids("scales"), [&of_the_paper[..], &of_a_tuesday].concat());
    let scales: Value = serde_json::from_str(&run(&["list", "scales", "--json"]).out).unwrap();
    let classes = |i: usize| -> Vec<(String, f64)> {
        let class = scales[i]["class"].as_array().unwrap().iter();
        class.map(|c| (c["name"].as_str().unwrap().to_owned(), c["from_c"].as_f64().unwrap())).collect()
    };
    let expected = [("raw", 0.0), ("rare", 50.0), ("medium", 60.0), ("well-done", 70.0)];
    assert_eq!(classes(0), expected.map(|(name, c)| (name.to_owned(), c)));
    assert!((0..17).all(|i| !scales[i]["source"].as_str().unwrap().is_empty()));
    let text = run(&["list", "scales"]).out;
    assert!(text.contains("medium-rare 55–60 °C") && text.contains("tender 40–85 %"), "{text}");
}

#[test]
fn there_are_five_pans_each_also_with_a_nonstick_coating() {
    let bare = ["aluminium-26", "carbon-steel-26", "cast-iron-26", "cast-iron-grill-26", "stainless-clad-26"];
    let expected: Vec<String> = bare.iter().flat_map(|p| [(*p).to_owned(), format!("{p}-nonstick")]).collect();
    assert_eq!(ids("pans"), expected);
}

#[test]
fn the_shipped_recipes_are_listed_by_id_and_title() {
    let mut all: Vec<&str> = SHIPPED.into_iter().chain(DISHES).chain(PANTRY).collect();
    all.sort_unstable();
    assert_eq!(ids("recipes"), all);
}

/// Every action of a step.
pub const ACTIONS: [&str; 20] = [
    "baste", "butter_g", "cool", "end", "flip", "halve", "hob_w", "lid", "move", "move_pan", "oil_g", "press", "put",
    "repeat", "rest", "shake", "tilt", "toss", "water_g", "wipe",
];

#[test]
fn the_hobs_are_listed_by_id_and_a_plan_on_an_unknown_one_is_refused() {
    assert_eq!(ids("hobs"), ["gas", "induction", "iron-plate", "radiant"]);
    let ran = run(&["plan", "--food", "beef-lean", "--target", "medium", "--hob-kind", "campfire"]);
    assert_eq!(ran.code, Some(2));
    assert!(
        ran.err.contains("campfire: is not a hob") && ran.err.contains("use one of: gas, induction"),
        "{}",
        ran.err
    );
}

#[test]
fn the_actions_are_listed_with_the_keys_of_their_tables_their_ranges_and_defaults() {
    assert_eq!(ids("actions"), ACTIONS);
    let actions: Value = serde_json::from_str(&run(&["list", "actions", "--json"]).out).unwrap();
    let shake = actions.as_array().unwrap().iter().find(|a| a["id"] == "shake").unwrap();
    let keys: Vec<&str> = shake["key"].as_array().unwrap().iter().map(|k| k["id"].as_str().unwrap()).collect();
    assert_eq!(keys, ["amplitude_mm", "for_s", "hz"]);
    let amplitude = &shake["key"][0];
    assert_eq!(
        (&amplitude["default"], &amplitude["min"], &amplitude["max"]),
        (&20.0.into(), &0.0.into(), &100.0.into())
    );
    assert!(run(&["list", "actions"]).out.contains("How often a second [Hz]; 3 by default. 0–8."));
}

#[test]
fn the_goals_are_listed_with_what_they_want_and_their_sources() {
    let of_the_paper =
        ["study-2013", "rare", "medium-rare", "medium", "well-done", "crust", "vegetables", "shrimp", "burger"];
    let of_a_tuesday = [
        "chicken",
        "pork",
        "cod",
        "salmon",
        "tofu",
        "potato",
        "egg-runny",
        "egg-jammy",
        "egg-firm",
        "onion",
        "pepper",
        "bacon",
        "mushroom",
    ];
    assert_eq!(ids("goals"), [&of_the_paper[..], &of_a_tuesday].concat());
    let goals: Value = serde_json::from_str(&run(&["list", "goals", "--json"]).out).unwrap();
    let of_2013 = &goals[0]["goal"];
    assert_eq!((of_2013["least_share_pct"].as_f64(), of_2013["class"].as_str()), (Some(40.0), Some("medium")));
    assert!((0..22).all(|i| !goals[i]["source"].as_str().unwrap().is_empty()));
    assert!(run(&["list", "goals"]).out.contains("40 % medium on paper-2013"));
}

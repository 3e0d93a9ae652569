//! The shipped recipes reach what their titles state.

use crate::cook::cooked::{Cooked, PANTRY, SHIPPED, cook, cooked};
use crate::running::run;

const CORE: &str = "/foods/0/core_c/peak";
const WELL_DONE: &str = "/foods/0/section_pct/well_done";

fn within(cooked: &Cooked, pointer: &str, range: std::ops::RangeInclusive<f64>) {
    let value = cooked.number(pointer);
    assert!(range.contains(&value), "{} of {} is not in {range:?}: {value}", pointer, cooked.summary["title"]);
}

/// A recipe takes the minutes that its file states.
fn takes_its_minutes(id: &str, summary: &serde_json::Value) {
    let library = saute_kitchen::Library::embedded().unwrap();
    let stated = saute_recipe::Recipe::parse(&library.recipes[id], id, &library).unwrap().minutes.unwrap();
    let took = summary["simulated_s"].as_f64().unwrap() / 60.0;
    assert!((took - stated).abs() <= 0.6, "{id}: {took} min, {stated} stated");
}

/// The summary of a recipe, cooked; it ends by its last step, in its minutes.
fn ended(id: &str) -> serde_json::Value {
    let ran = run(&["cook", id, "--json"]);
    assert_eq!(ran.code, Some(0), "{id}: {}", ran.err);
    let summary: serde_json::Value = serde_json::from_str(&ran.out).unwrap();
    assert_eq!(summary["stopped_by"], "end", "{id}");
    takes_its_minutes(id, &summary);
    summary
}

#[test]
fn every_shipped_recipe_ends_by_its_last_step() {
    for id in SHIPPED {
        assert_eq!(cooked(id).ran.code, Some(0), "{id}");
        assert_eq!(cooked(id).summary["stopped_by"], "end", "{id}");
        assert_eq!(cooked(id).summary["warnings"].as_array().map(Vec::len), Some(0), "{id}");
        takes_its_minutes(id, &cooked(id).summary);
    }
}

#[test]
fn the_energy_balance_of_every_shipped_recipe_closes_within_half_a_percent() {
    for id in SHIPPED {
        let share = cooked(id).number("/energy_j/imbalance").abs() / cooked(id).number("/energy_j/hob");
        assert!(share < 0.005, "{id}: {share}");
    }
}

#[test]
fn the_core_of_every_shipped_recipe_rests_up_to_what_the_title_says() {
    within(cooked("rare"), CORE, 50.0..=55.0);
    within(cooked("medium"), CORE, 58.0..=63.0);
    within(cooked("flip-every-30-s"), CORE, 58.0..=63.0);
    within(cooked("well-done"), CORE, 71.0..=80.0);
}

#[test]
fn a_rare_steak_is_mostly_below_60_degrees_and_a_well_done_one_above_70() {
    let rare = cooked("rare");
    assert!(rare.number("/foods/0/section_pct/raw") + rare.number("/foods/0/section_pct/rare") > 40.0);
    within(cooked("well-done"), WELL_DONE, 80.0..=100.0);
    within(cooked("well-done"), "/foods/0/section_pct/raw", 0.0..=1.0);
}

#[test]
fn every_shipped_steak_has_a_crust_on_both_faces_and_is_not_burnt() {
    for id in SHIPPED {
        for face in ["top", "bottom"] {
            within(cooked(id), &format!("/foods/0/surfaces/{face}/browned_pct"), 50.0..=100.0);
            within(cooked(id), &format!("/foods/0/surfaces/{face}/charred_pct"), 0.0..=5.0);
        }
        within(cooked(id), "/pan_c/peak", 200.0..=240.0);
    }
}

#[test]
fn frequent_flips_give_the_same_core_sooner_and_with_a_thinner_grey_band() {
    let (one, many) = (cooked("medium"), cooked("flip-every-30-s"));
    assert!((one.number(CORE) - many.number(CORE)).abs() < 3.0);
    assert!(many.number(WELL_DONE) < one.number(WELL_DONE) - 4.0);
    let fried = |c: &Cooked| c.time_of("rest") - c.time_of("put");
    assert!(fried(many) < 0.75 * fried(one), "{} s, {} s", fried(many), fried(one));
}

#[test]
fn a_steak_that_is_flipped_every_30_s_is_never_left_longer() {
    let steps = cooked("flip-every-30-s").summary["steps"].as_array().unwrap();
    let turned = ["put", "flip", "rest"];
    let times: Vec<f64> = steps
        .iter()
        .filter(|s| turned.contains(&s["action"].as_str().unwrap()))
        .map(|s| s["time_s"].as_f64().unwrap())
        .collect();
    assert!(times.windows(2).all(|w| w[1] - w[0] < 30.05), "{times:?}");
}

#[test]
fn the_same_recipe_gives_the_same_series_byte_for_byte() {
    assert_eq!(cook("rare").files["series.csv"], cooked("rare").files["series.csv"]);
}

/// The dish of the paper and the shrimps: most pieces are still in the pan or on the board, and done.
#[test]
fn the_dishes_with_many_foods_end_done_and_lose_hardly_anything() {
    for (id, most_lost, cores) in [("shrimp", 1, 45.0..=90.0), ("steak-carrots-leeks", 3, 50.0..=100.0)] {
        let summary = ended(id);
        let foods = summary["foods"].as_array().unwrap();
        let lost = foods.iter().filter(|f| ["table", "glass"].contains(&f["place"].as_str().unwrap())).count();
        assert!(lost <= most_lost, "{id}: {lost} fell out");
        for food in foods {
            let core = food["core_c"]["peak"].as_f64().unwrap();
            assert!(cores.contains(&core), "{id}: {} {core}", food["id"]);
        }
        let share = summary["energy_j"]["imbalance"].as_f64().unwrap() / summary["energy_j"]["hob"].as_f64().unwrap();
        assert!(share.abs() < 0.005, "{id}: {share}");
    }
}

/// Classes of the core, on the foods' own scales, that the recipes of the pantry aim at, and the least browned share of a face [%]: a
/// sunny egg is white, the skin of a pepper hardly browns.
const PANTRY_ENDS: [(&str, f64); 10] = [
    ("flaky", 60.0),
    ("crisp", 60.0),
    ("hot", 60.0),
    ("juicy", 60.0),
    ("meaty", 60.0),
    ("tender", 0.0),
    ("juicy", 60.0),
    ("silky", 60.0),
    ("sweet", 60.0),
    ("runny", 0.0),
];

#[test]
fn the_recipes_of_the_pantry_end_in_the_class_of_their_goal_browned_and_not_burnt() {
    for (id, (class, browned)) in PANTRY.into_iter().zip(PANTRY_ENDS) {
        let summary = ended(id);
        let food = &summary["foods"][0];
        let [(_, scale)] = food["doneness"].as_object().unwrap().iter().collect::<Vec<_>>()[..] else { panic!("{id}") };
        assert_eq!(scale["class"], class, "{id}");
        let of = |face: &str, what: &str| food["surfaces"][face][what].as_f64().unwrap();
        assert!(of("top", "browned_pct").max(of("bottom", "browned_pct")) >= browned, "{id}");
        assert!(of("top", "charred_pct").max(of("bottom", "charred_pct")) < 5.0, "{id}");
        let energy = &summary["energy_j"];
        assert!(energy["imbalance"].as_f64().unwrap().abs() < 1e-9 * energy["hob"].as_f64().unwrap(), "{id}");
    }
}

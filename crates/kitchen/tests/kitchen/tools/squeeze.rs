//! Promise: a press and a fresh cut let out juice that is free, and none that the flesh still binds.

use saute_kitchen::Library;
use saute_recipe::{Cook, Recipe, Summary};

/// Cooks one piece in a pan by steps, one a line.
fn cooked(kind: &str, size_mm: &str, initial_c: f64, steps: &[&str]) -> Summary {
    ended(kind, size_mm, initial_c, steps).summary(0.0)
}

fn ended(kind: &str, size_mm: &str, initial_c: f64, steps: &[&str]) -> Cook {
    let library = Library::embedded().expect("embedded data");
    let steps: String = steps.iter().map(|step| format!("[[step]]\n{}\n", step.replace("; ", "\n"))).collect();
    let text = format!(
        "max_s = 3600\n[pan]\nkind = \"cast-iron-26\"\ninitial_c = 160\n[[food]]\nid = \"food\"\nkind = \"{kind}\"\n\
         outline = \"plain\"\nsize_mm = {size_mm}\ninitial_c = {initial_c}\ncoarseness = 2\n{steps}"
    );
    let mut cook =
        Cook::new(Recipe::parse(&text, "squeeze.toml", &library).expect("parses"), &library).expect("begins");
    while cook.stopped().is_none() {
        cook.advance().expect("runs");
    }
    cook
}

/// A patty that is pressed twice for half a minute with a force [N], each time when its core has 60 °C or more, and taken
/// out at 71 °C: juice that ran off [g] and time [s].
fn pressed_patty(newtons: f64) -> (f64, f64) {
    let press = format!("press = {{ food = \"food\", n = {newtons}, for_s = 30 }}");
    let pressed = if newtons > 0.0 { press.as_str() } else { "after_s = 30; hob_w = 700" };
    let summary = cooked(
        "beef-patty",
        "[110, 20]",
        5.0,
        &[
            "hob_w = 700",
            "put = \"food\"",
            "after_s = 180; flip = \"food\"",
            "when = { food = \"food\", core_c = 55 }; flip = \"food\"",
            pressed,
            pressed,
            "when = { food = \"food\", core_c = 71 }; end = true",
        ],
    );
    let food = &summary.foods[0];
    println!(
        "{newtons} N: {:.2} g of juice, {:.0} s, {:.1} %",
        food.water_g.dripped, summary.simulated_s, food.lost_pct
    );
    (food.water_g.dripped, summary.simulated_s)
}

#[test]
fn a_pressed_patty_loses_juice_with_the_force_and_cooks_faster() {
    let [none, hand, hard, heavy] = [0.0, 10.0, 40.0, 100.0].map(pressed_patty);
    assert!(none.0 + 0.2 < hand.0 && hand.0 + 0.5 < hard.0 && hard.0 < heavy.0, "{none:?} {hand:?} {hard:?} {heavy:?}");
    // It levels off: the first newtons count for more.
    assert!((heavy.0 - hard.0) / 60.0 < (hard.0 - hand.0) / 30.0, "{hand:?} {hard:?} {heavy:?}");
    assert!(heavy.1 < none.1, "{none:?} {heavy:?}");
}

#[test]
fn raw_meat_loses_nothing_under_a_press() {
    let fried = |press: &str| {
        let steps = ["put = \"food\"", press, "after_s = 5; end = true"];
        cooked("beef-lean", "[90, 60, 25]", 5.0, &steps).foods[0].lost_pct
    };
    let (pressed, left) =
        (fried("press = { food = \"food\", n = 100, for_s = 20 }"), fried("after_s = 20; hob_w = 10"));
    assert!((pressed - left).abs() < 1.0, "{pressed} {left}");
}

/// Cut at once, a steak leaves more on the board than one that has rested for five minutes.
#[test]
fn a_steak_that_is_cut_at_once_runs_more_than_one_that_has_rested() {
    let on_board = |rest_s: f64| {
        let out = [
            "hob_w = 900",
            "put = \"food\"",
            "after_s = 120; flip = \"food\"",
            "after_s = 120; flip = \"food\"",
            "when = { food = \"food\", core_c = 58 }; rest = \"food\"",
        ];
        let waited = format!("after_s = {rest_s}; halve = \"food\"");
        let since = |steps: &[&str]| cooked("beef-lean", "[100, 70, 25]", 5.0, steps).foods[0].water_g.dripped;
        let cut = [out.as_slice(), &[waited.as_str(), "after_s = 240; end = true"]].concat();
        let waits = format!("after_s = {rest_s}; end = true");
        let before = [out.as_slice(), &[waits.as_str()]].concat();
        let ran = since(&cut) - since(&before);
        println!("cut after {rest_s} s: {ran:.2} g run in the four minutes after the cut");
        ran
    };
    let (at_once, rested) = (on_board(2.0), on_board(300.0));
    assert!(at_once > 1.2 * rested, "{at_once} {rested} g");
}

/// Ice does not give way under a press; a raw patty does.
#[test]
fn a_press_flattens_minced_meat_but_no_ice() {
    let flattened = |initial_c: f64| {
        let steps = ["hob_w = 500", "put = \"food\"", "press = { food = \"food\", n = 60, for_s = 15 }", "end = true"];
        ended("beef-patty", "[90, 20]", initial_c, &steps).kitchen.pieces()[0].state.stretch.flattened
    };
    let (raw, frozen) = (flattened(5.0), flattened(-18.0));
    assert!(raw > 0.1 && frozen == 0.0, "{raw} {frozen}");
}

//! Promise: a cook in the pan balances, loses juice and heat as cooks do, and never gets worse with more heat.

use saute_kitchen::{Kitchen, Library, celsius};
use saute_recipe::{Cook, Recipe, Summary};

use crate::stove::{imbalance, library};

/// Runs a recipe to its end, with a look at the kitchen after every tick.
fn watched(library: &Library, text: &str, mut look: impl FnMut(&Kitchen)) -> Cook {
    let recipe = Recipe::parse(text, "frying.toml", library).unwrap_or_else(|e| panic!("{e}"));
    let mut cook = Cook::new(recipe, library).expect("begins");
    while cook.stopped().is_none() {
        cook.fire().unwrap_or_else(|e| panic!("{e}"));
        cook.tick();
        look(&cook.kitchen);
    }
    cook
}

fn cooked(library: &Library, text: &str) -> Summary {
    watched(library, text, |_| ()).summary(0.0)
}

/// A recipe from bare lines of steps, one step a line.
fn recipe(pan: &str, foods: &str, steps: &[String]) -> String {
    let steps: Vec<String> = steps.iter().map(|step| format!("[[step]]\n{}\n", step.replace("; ", "\n"))).collect();
    format!(
        "max_s = 7200\n[pan]\n{}\n[[food]]\n{}\n{}",
        pan.replace("; ", "\n"),
        foods.replace("; ", "\n"),
        steps.concat()
    )
}

fn steps(lines: &[&str]) -> Vec<String> {
    lines.iter().map(|line| (*line).to_owned()).collect()
}

/// Condensation under the lid, juice through the coldest level, its boiling in the film of the pan, a puddle on the board.
#[test]
fn mass_and_energy_balance_with_condensation_juice_and_film_boiling() {
    let text = recipe(
        "kind = \"carbon-steel-26\"; initial_c = 190",
        "id = \"steak\"; kind = \"beef-marbled\"; size_mm = [110, 75, 20]; initial_c = 5",
        &steps(&[
            "hob_w = 1200",
            "oil_g = 8",
            "put = \"steak\"",
            "after_s = 120; flip = \"steak\"",
            "lid = true",
            "after_s = 60; lid = false",
            "water_g = 30",
            "after_s = 60; flip = \"steak\"",
            "after_s = 90; rest = \"steak\"",
            "hob_w = 0",
            "after_s = 120; end = true",
        ]),
    );
    let mut worst = 0.0_f64;
    let cook = watched(&library(), &text, |kitchen| worst = worst.max(imbalance(kitchen)));
    assert!(worst < 1e-9, "energy: {worst}");
    let food = &cook.summary(0.0).foods[0];
    let left = food.water_g.evaporated + food.water_g.dripped + food.fat_rendered_g;
    let lost = food.mass_g.start - food.mass_g.end;
    assert!(lost > 5.0 && (left / lost - 1.0).abs() < 1e-6, "mass: {lost} g lost, {left} g accounted for");
}

/// Deep oil heats the lower faces of a piece that is turned, shaken and tossed in it; no heat counts twice.
#[test]
fn energy_balances_in_deep_oil() {
    let text = recipe(
        "kind = \"carbon-steel-26\"; initial_c = 170",
        "id = \"steak\"; kind = \"beef-lean\"; size_mm = [60, 50, 15]; initial_c = 5; mesh = \"2013\"",
        &steps(&[
            "hob_w = 1000",
            "oil_g = 120",
            "put = \"steak\"",
            "after_s = 20; flip = \"steak\"",
            "after_s = 10; shake = 3",
            "after_s = 5; toss = true",
            "after_s = 10; end = true",
        ]),
    );
    let (mut worst, mut immersed) = (0.0_f64, 0.0_f64);
    watched(&library(), &text, |kitchen| {
        worst = worst.max(imbalance(kitchen));
        immersed = immersed.max(kitchen.pan_state().oil_mass());
    });
    assert!(immersed > 0.1 && worst < 1e-9, "{immersed} kg of oil, {worst}");
}

/// Juice is driven through the cold level to the upper face before a late turn.
#[test]
fn juice_beads_on_the_cold_face_before_a_late_turn() {
    let text = recipe(
        "kind = \"cast-iron-26\"; initial_c = 190",
        "id = \"steak\"; kind = \"beef-lean\"; size_mm = [120, 80, 20]; initial_c = 5",
        &steps(&["hob_w = { hold_c = 190, w = 2000 }", "put = \"steak\"", "after_s = 420; end = true"]),
    );
    let cook = watched(&library(), &text, |_| ());
    let piece = &cook.kitchen.pieces()[0];
    let films = piece.model.juice_films(&piece.state);
    let high = 1e-3 * 15.0;
    let above = (0..films.len()).filter(|node| piece.model.mesh().position(*node)[2] > high);
    let wettest = above.map(|node| films[node]).fold(0.0, f64::max);
    assert!(wettest > 0.2, "{wettest}");
}

/// Rise of the loss with the peak of the core: 32 mm from 5 °C, turned each minute at 180 °C, rested.
#[test]
fn the_loss_rises_by_half_to_nine_tenths_of_a_percent_a_kelvin() {
    let library = library();
    let rested = |off: f64| {
        let turning =
            format!("repeat = {{ flip = \"steak\", every_s = 60, until = {{ food = \"steak\", core_c = {off} }} }}");
        let text = recipe(
            "kind = \"cast-iron-26\"; initial_c = 180",
            "id = \"steak\"; kind = \"beef-lean\"; size_mm = [80, 60, 32]; initial_c = 5",
            &[
                steps(&["hob_w = { hold_c = 180, w = 2000 }", "put = \"steak\""]),
                vec![turning],
                steps(&["rest = \"steak\"", "hob_w = 0", "after_s = 240; end = true"]),
            ]
            .concat(),
        );
        let food = &cooked(&library, &text).foods[0];
        (food.core_c.peak, food.lost_pct)
    };
    let ((low_c, low), (high_c, high)) = (rested(50.0), rested(66.0));
    let slope = (high - low) / (high_c - low_c);
    assert!((0.5..=0.9).contains(&slope), "{slope} %/K: {low} % at {low_c} °C, {high} % at {high_c} °C");
}

/// The shipped patty sags flat under its weight. The softest one that is stiff enough to be domed by a millimetre, on the mean
/// over the cook, takes little longer to cook and browns less. (A dome that sags again within a minute costs nothing.)
#[test]
fn a_domed_patty_takes_at_most_15_percent_longer_and_browns_less() {
    let text = recipe(
        "kind = \"cast-iron-26\"; initial_c = 190",
        // A natural one is domed before it is fried, and what this dome adds or takes depends on the side it lies on.
        "id = \"patty\"; kind = \"beef-patty\"; size_mm = [110, 16]; initial_c = 5; outline = \"plain\"; coarseness = 1.5",
        &steps(&[
            "hob_w = { hold_c = 190, w = 2000 }",
            "put = \"patty\"",
            "after_s = 240; flip = \"patty\"",
            "when = { food = \"patty\", core_c = 71 }; end = true",
        ]),
    );
    let fry = |relaxed_share: Option<f64>| {
        let mut library = library();
        for kinetics in library.kinetics.values_mut() {
            kinetics.texture.relaxed_share = relaxed_share.unwrap_or(kinetics.texture.relaxed_share);
        }
        let mut domes_mm = Vec::new();
        let look = |kitchen: &Kitchen| domes_mm.push(1e3 * kitchen.pieces()[0].state.stretch.dome.abs());
        let summary = watched(&library, &text, look).summary(0.0);
        (summary, domes_mm.iter().sum::<f64>() / domes_mm.len() as f64)
    };
    let (flat, least) = fry(None);
    let (domed, most) = [0.3, 0.4, 0.5, 0.6, 0.8, 1.0]
        .into_iter()
        .map(|share| fry(Some(share)))
        .find(|(_, dome)| *dome > least + 1.0)
        .expect("stiff meat domes");
    let ratio = domed.simulated_s / flat.simulated_s;
    assert!(
        (1.0..=1.15).contains(&ratio),
        "{} s with {most} mm, {} s with {least}",
        domed.simulated_s,
        flat.simulated_s
    );
    let browned = |summary: &Summary| summary.foods[0].browned_pct();
    assert!(browned(&domed) < browned(&flat) - 2.0, "{} {}", browned(&domed), browned(&flat));
}

/// A condition that is past does not wait for a crossing.
#[test]
fn a_condition_that_is_past_does_not_wait() {
    let text = recipe(
        "kind = \"carbon-steel-26\"; initial_c = 150",
        "id = \"coin\"; kind = \"carrot-coin\"; initial_c = 58",
        &steps(&["put = \"coin\"", "when = { food = \"coin\", core_c = 52 }; end = true"]),
    );
    let summary = cooked(&library(), &text);
    assert!(summary.simulated_s < 1.0 && summary.waiting_step.is_none(), "{}", summary.simulated_s);
}

/// Times to 52 and 55 °C [s], and the browned and charred share of both faces at a moment [%].
struct Fried {
    times: [f64; 2],
    faces: [[f64; 2]; 2],
}

fn fried(library: &Library, pan: &str, kind: &str, watts: f64) -> Fried {
    let turn = if kind.starts_with("beef") { 150 } else { 90 };
    let text = recipe(
        &format!("kind = \"{pan}\"; initial_c = 200"),
        &format!("id = \"food\"; kind = \"{kind}\""),
        &[
            format!("hob_w = {watts}"),
            "put = \"food\"".to_owned(),
            format!("after_s = {turn}; flip = \"food\""),
            "when = { food = \"food\", core_c = 55 }; hob_w = 0".to_owned(),
            "after_s = 200; end = true".to_owned(),
        ],
    );
    let mut fried = Fried { times: [f64::NAN; 2], faces: [[0.0; 2]; 2] };
    watched(library, &text, |kitchen| {
        let piece = &kitchen.pieces()[0];
        for (time, goal) in fried.times.iter_mut().zip([52.0, 55.0]) {
            if time.is_nan() && celsius(piece.core()) >= goal {
                *time = kitchen.time_s();
            }
        }
        // While the hob is still at its power, if the food is not done before.
        if kitchen.time_s() < f64::from(turn) + 60.0 {
            let face = |up: [f64; 3]| piece.model.face_reading(&piece.state, up);
            let faces = [face(piece.up().map(|v| -v)), face(piece.up())];
            fried.faces = faces.map(|face| [face.browned_pct, face.charred_pct]);
        }
    });
    fried
}

/// From the same pan temperature, more power never lengthens a cook by more than 1 % and never makes a face paler by more
/// than 2 points while less than 5 % of it is charred; every shipped plain pan, every food.
#[test]
#[ignore = "112 whole cooks: a few minutes"]
fn hotter_is_never_slower_nor_paler_on_any_plain_pan() {
    let library = library();
    let mut failures = Vec::new();
    for pan in library.pans.keys().filter(|pan| !pan.contains("grill")) {
        for kind in library.foods.keys() {
            let [mut fastest, mut browned] = [[f64::INFINITY; 2], [0.0_f64; 2]];
            for watts in [500.0, 1100.0, 1500.0, 2000.0] {
                let fried = fried(&library, pan, kind, watts);
                for k in 0..2 {
                    if fried.times[k].is_nan() || fried.times[k] > 1.01 * fastest[k] {
                        failures.push(format!("{kind}, {pan}, {watts} W: {:?} s after {fastest:?}", fried.times));
                    }
                    fastest[k] = fastest[k].min(fried.times[k]);
                    let [brown, char] = fried.faces[k];
                    if char < 5.0 && brown < browned[k] - 2.0 {
                        failures.push(format!("{kind}, {pan}, {watts} W, face {k}: {brown} % after {} %", browned[k]));
                    }
                    browned[k] = browned[k].max(brown);
                }
            }
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

/// Streaks of lean shorten beside streaks of fat: bacon waves, lies on its troughs with either face, and browns on both where it lies.
#[test]
fn bacon_waves_and_browns_where_it_lies_and_a_steak_lies_flat() {
    let slice = |kind: &str, size: &str| {
        recipe(
            "kind = \"carbon-steel-26\"; initial_c = 165; oil_g = 3",
            &format!("id = \"slice\"; kind = \"{kind}\"; size_mm = {size}; initial_c = 6; coarseness = 1.5"),
            &steps(&["hob_w = 500", "put = \"slice\"", "after_s = 150; flip = \"slice\"", "after_s = 150; end = true"]),
        )
    };
    let mut highest_mm = Vec::new();
    let wave = |kitchen: &Kitchen| 1e3 * kitchen.pieces()[0].state.stretch.waves;
    let bacon = watched(&library(), &slice("bacon", "[100, 32, 2.6]"), |kitchen| highest_mm.push(wave(kitchen)));
    assert!(highest_mm.is_sorted() && highest_mm[0] == 0.0, "it sets in its waves");
    let last_mm = *highest_mm.last().expect("ticks");
    assert!((0.5..6.0).contains(&last_mm), "{last_mm} mm");
    let piece = &bacon.kitchen.pieces()[0];
    for up in [[0.0, 0.0, 1.0], [0.0, 0.0, -1.0]] {
        let gaps = || piece.model.patches_below(up).map(|patch| piece.model.patch_dome_gap(&piece.state, patch, up));
        let lie = gaps().filter(|gap| *gap < 0.1e-3).count();
        let lifted = gaps().filter(|gap| *gap > 0.5e-3).count();
        assert!(
            lie > gaps().count() / 6 && lifted > gaps().count() / 6,
            "{lie} lie and {lifted} are lifted of {}",
            gaps().count()
        );
    }
    let steak = watched(&library(), &slice("beef-lean", "[100, 60, 15]"), |_| ());
    assert_eq!(wave(&steak.kitchen), 0.0);
}

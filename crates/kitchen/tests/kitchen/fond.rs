//! Promise: juice that dries on the hot pan leaves solids that brown and char, water dissolves them again, their mass is
//! kept, and nothing else in the kitchen feels them.

use saute_kitchen::food::Rules;
use saute_kitchen::{Command, Kitchen, Library, MeshSize, OutlineKind, PieceOrder, RestOn, kelvin};
use saute_recipe::{Cook, Recipe};

use crate::stove::{apply, library, run};

/// A steak that fries for a while in a hot pan.
fn frying(library: &Library, watts: f64, seconds: f64) -> Kitchen {
    let mut kitchen = Kitchen::new(library, "carbon-steel-26", kelvin(170.0)).expect("pan");
    let order = PieceOrder {
        id: "steak".into(),
        kind: "beef-lean".into(),
        size: [0.10, 0.07, 0.015],
        temperature: kelvin(15.0),
        seed: 1,
        coarseness: 2.0,
        rules: Rules::Full,
        mesh: MeshSize::Default,
        outline: OutlineKind::Plain,
    };
    kitchen.add(library, &order).expect("food");
    apply(&mut kitchen, Command::Put { food: "steak".into(), at: [0.0, 0.0], heap: false });
    apply(&mut kitchen, Command::Hob(watts));
    run(&mut kitchen, seconds);
    kitchen
}

/// Dried, dissolved and spilled solids [kg].
fn solids(kitchen: &Kitchen) -> [f64; 3] {
    let fond = &kitchen.pan_state().liquids.fond;
    [fond.dried_kg(&kitchen.pan_model().liquids.bed)[0], fond.dissolved_kg(), fond.spilled]
}

/// Mean browning and charring of the fond [-].
fn extents(kitchen: &Kitchen) -> [f64; 2] {
    let [mass, browned, charred] = kitchen.pan_state().liquids.fond.dried_kg(&kitchen.pan_model().liquids.bed);
    [browned / mass, charred / mass]
}

fn take_out(kitchen: &mut Kitchen) {
    apply(kitchen, Command::Rest { food: "steak".into(), on: RestOn::Board });
    while kitchen.busy() {
        kitchen.step();
    }
}

#[test]
fn the_solids_of_juice_are_kept_through_drying_deglazing_and_spilling() {
    let library = library();
    let mut kitchen = frying(&library, 700.0, 400.0);
    let brought = |kitchen: &Kitchen| kitchen.pan_state().liquids.fond.brought;
    let balance = |kitchen: &Kitchen| solids(kitchen).iter().sum::<f64>() / brought(kitchen) - 1.0;
    assert!(balance(&kitchen).abs() < 1e-12, "{}", balance(&kitchen));
    let (juice, state) = (&library.fond.juice, &kitchen.pieces()[0].state);
    let least = juice.solids * state.dripped;
    let most = juice.solids * (state.dripped + juice.sticking * state.evaporated);
    assert!((least..most).contains(&brought(&kitchen)) && brought(&kitchen) > 1e-5, "{}", brought(&kitchen));
    apply(&mut kitchen, Command::Water(0.2));
    run(&mut kitchen, 20.0);
    assert!(balance(&kitchen).abs() < 1e-12, "{}", balance(&kitchen));
    apply(&mut kitchen, Command::Tilt { angle: 0.9, towards: 1.0 });
    run(&mut kitchen, 10.0);
    let [_, _, spilled] = solids(&kitchen);
    assert!(spilled > 0.0 && balance(&kitchen).abs() < 1e-12, "{spilled} {}", balance(&kitchen));
    let fond = &kitchen.pan_state().liquids.fond;
    let fields = [&fond.dried, &fond.dissolved].map(|s| [&s.mass, &s.browned, &s.charred]);
    assert!(fields.iter().flatten().all(|f| f.iter().all(|v| *v >= 0.0)));
}

#[test]
fn juice_that_dries_on_the_hot_pan_leaves_fond_that_browns() {
    let mut kitchen = frying(&library(), 700.0, 300.0);
    take_out(&mut kitchen);
    // The juice that has dripped boils away first.
    run(&mut kitchen, 120.0);
    let [dried, dissolved, _] = solids(&kitchen);
    assert!(dried > 10.0 * dissolved, "{dried} {dissolved}");
    let [browning, charring] = extents(&kitchen);
    assert!(browning > 0.3 && charring < browning, "{browning} {charring}");
    let (pan, state) = (kitchen.pan_model(), kitchen.pan_state());
    let middle = state.fond(&pan.locator.locate_or_nearest(&pan.section, [0.0, 0.0]));
    assert!(middle.mass_kg_m2 > 0.0 && (0.0..=1.0).contains(&middle.browning), "{middle:?}");
    assert!(state.liquids.fond.share.iter().all(|s| (0.0..=1.0).contains(s)));
    assert!(state.liquids.fond.share.iter().any(|s| *s > 0.05), "{dried} {middle:?}");
}

#[test]
fn a_pan_that_is_too_hot_chars_its_fond() {
    let charred = |watts: f64| {
        let mut kitchen = frying(&library(), 400.0, 120.0);
        take_out(&mut kitchen);
        apply(&mut kitchen, Command::Hob(watts));
        run(&mut kitchen, 120.0);
        extents(&kitchen)[1]
    };
    let (low, high) = (charred(0.0), charred(1800.0));
    assert!(high > 0.6 && low < 0.5 * high, "{low} {high}");
}

#[test]
fn water_thrown_in_dissolves_the_fond() {
    let mut kitchen = frying(&library(), 700.0, 300.0);
    take_out(&mut kitchen);
    run(&mut kitchen, 30.0);
    let before = solids(&kitchen)[0];
    apply(&mut kitchen, Command::Water(0.15));
    run(&mut kitchen, 10.0);
    let soon = solids(&kitchen)[0];
    run(&mut kitchen, 80.0);
    let after = solids(&kitchen);
    assert!(soon < before && after[0] < 0.3 * before && after[1] > 0.6 * before, "{before} {soon} {after:?}");
    let fond = &kitchen.pan_state().liquids.fond;
    assert!(fond.dissolved.browned.iter().sum::<f64>() > 0.0, "the sauce is brown");
    run(&mut kitchen, 900.0);
    let dry = solids(&kitchen);
    assert!(kitchen.pan_state().water_mass() < 1e-6 && dry[0] > 0.99 * before, "it dries on again: {dry:?}");
}

#[test]
fn fond_changes_neither_heat_nor_food() {
    let files = Library::embedded_files();
    let without = files["fond.toml"].replacen("solids = 0.05", "solids = 0.0", 1);
    assert!(without != files["fond.toml"]);
    let plain = Library::with(&[("fond.toml".into(), without)]).expect("sound");
    let (with, without) = (frying(&library(), 700.0, 120.0), frying(&plain, 700.0, 120.0));
    assert!(solids(&with)[0] > 0.0 && solids(&without) == [0.0; 3]);
    assert!(with.pieces()[0].state == without.pieces()[0].state);
    assert_eq!(with.pan_state().temperature, without.pan_state().temperature);
    assert_eq!(with.pan_state().water_mass(), without.pan_state().water_mass());
    assert_eq!(with.energy(), without.energy());
}

#[test]
fn the_summary_tells_the_fond_in_grams() {
    let library = library();
    let text = "[pan]\ninitial_c = 200\n[[food]]\nid = \"s\"\nkind = \"beef-lean\"\nsize_mm = [80, 60, 12]\n\
        [[step]]\nhob_w = 600\n[[step]]\nput = \"s\"\n[[step]]\nafter_s = 200\nend = true\n";
    let mut cook = Cook::new(Recipe::parse(text, "fond.toml", &library).expect("parses"), &library).expect("sets out");
    while cook.stopped().is_none() {
        cook.advance().expect("runs");
    }
    let told = cook.summary(0.0).liquids_g;
    let [dried, dissolved, _] = solids(&cook.kitchen);
    assert!((told.fond - 1e3 * dried).abs() < 1e-12 && (told.dissolved - 1e3 * dissolved).abs() < 1e-12);
    assert!(told.fond > 0.0 && told.fond_browned <= told.fond && told.fond_charred <= told.fond);
}

#[test]
fn impossible_numbers_of_fond_are_refused_where_they_stand() {
    let files = Library::embedded_files();
    for (from, to) in [("solids = 0.05", "solids = 5.0"), ("saturation = 0.6", "saturation = 0.0")] {
        let error = Library::with(&[("fond.toml".into(), files["fond.toml"].replacen(from, to, 1))]).expect_err(to);
        assert!(error.file == "fond.toml" && error.line > 1 && error.message.contains("use "), "{error}");
    }
}

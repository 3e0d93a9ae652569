//! Promise: the hob does what hobs do: low settings are switched, a lifted pan or one off its ring gets nothing, an
//! overheated one is limited; and the rules of 2013 are there for comparison, labelled.

use saute_kitchen::food::Rules;
use saute_kitchen::{Command, Kitchen, celsius, kelvin};
use saute_recipe::{Cook, Recipe};

use crate::hobs::hold::steak;
use crate::stove::{apply, library, run};

fn empty_pan(celsius: f64, power: f64) -> Kitchen {
    let mut kitchen = Kitchen::new(&library(), "carbon-steel-26", kelvin(celsius)).expect("pan");
    kitchen.apply(&Command::Hob(power)).expect("power");
    kitchen
}

#[test]
fn a_low_setting_gives_its_mean_power() {
    let mut kitchen = empty_pan(20.0, 200.0);
    run(&mut kitchen, 1.0);
    assert!((kitchen.energy().hob - 400.0).abs() < 1.0, "on for the first 0.8 s of 2: {}", kitchen.energy().hob);
    run(&mut kitchen, 59.0);
    assert!((kitchen.energy().hob / 60.0 - 200.0).abs() < 0.5, "{}", kitchen.energy().hob / 60.0);
}

#[test]
fn a_pan_lifted_more_than_15_mm_or_off_its_ring_gets_no_power_and_cools() {
    for (at, lift) in [([0.0, 0.0], 0.016), ([0.12, 0.0], 0.0)] {
        let mut kitchen = empty_pan(200.0, 1500.0);
        kitchen.apply(&Command::MovePan { at, lift }).expect("moves");
        run(&mut kitchen, 2.0);
        let on_its_way = kitchen.energy().hob;
        run(&mut kitchen, 60.0);
        assert_eq!((kitchen.energy().hob, kitchen.hob_drawn_w()), (on_its_way, 0.0));
        assert!(on_its_way < 1000.0, "it is there within two thirds of a second: {on_its_way} J");
        assert!(celsius(kitchen.pan_temperature()) < 200.0);
        kitchen.apply(&Command::MovePan { at: [0.0, 0.0], lift: 0.0 }).expect("moves");
        run(&mut kitchen, 2.0);
        let back = kitchen.energy().hob;
        run(&mut kitchen, 10.0);
        assert!((kitchen.energy().hob - back - 15_000.0).abs() < 1.0);
        assert!(kitchen.energy().imbalance.abs() < 1e-6 * 15_000.0);
    }
    let mut kitchen = empty_pan(200.0, 1500.0);
    kitchen.apply(&Command::MovePan { at: [0.0, 0.0], lift: 0.0075 }).expect("moves");
    run(&mut kitchen, 2.0);
    let there = kitchen.energy().hob;
    run(&mut kitchen, 10.0);
    assert!((kitchen.energy().hob - there - 0.7 * 15_000.0).abs() < 1.0, "half-way up the coupling has fallen to 0.7");
    assert!(kitchen.apply(&Command::MovePan { at: [0.0, 0.0], lift: 2.0 }).is_err());
}

/// Lowest and highest mean temperature of the floor, and the hottest place of the pan, over so many seconds [°C].
fn floor_over(kitchen: &mut Kitchen, seconds: u32) -> [f64; 3] {
    (0..seconds).fold([f64::MAX, f64::MIN, f64::MIN], |[lowest, highest, hottest], _| {
        run(kitchen, 1.0);
        let (floor, place) = (celsius(kitchen.pan_temperature()), celsius(kitchen.hottest_temperature()));
        [lowest.min(floor), highest.max(floor), hottest.max(place)]
    })
}

/// Temperature at which canola, which is in the pan, catches fire [°C].
const FIRE_C: f64 = 350.0;

/// The limit is that of the floor's mean, whatever the pan, and food that takes heat from the floor does not raise it. The
/// electronics infer the rings of an empty pan within 6 K; below food they know the mean of a ring, not its hottest place.
#[test]
fn an_empty_pan_at_full_power_settles_below_the_limit_and_food_does_not_raise_that() {
    let library = library();
    let control = library.hobs["induction"].control.as_ref().expect("a coil");
    let (settled, limit) = (control.limit_c - control.resume_k, control.limit_c);
    let hottest = limit + control.hottest_k + 6.0;
    for pan in ["aluminium-26", "carbon-steel-26", "cast-iron-26", "stainless-clad-26"] {
        for power in [2000.0, 3500.0] {
            let mut kitchen = Kitchen::new(&library, pan, kelvin(20.0)).expect("pan");
            apply(&mut kitchen, Command::Hob(power));
            let on_its_way = floor_over(&mut kitchen, 600);
            assert!(on_its_way[1] < limit && on_its_way[2] < hottest, "{pan} {power}: {on_its_way:?}");
            let empty = floor_over(&mut kitchen, 300);
            assert!(settled < empty[0] && kitchen.pan_state().limited, "{pan} {power}: {empty:?}");
            kitchen.add(&library, &steak([0.12, 0.08, 0.02])).expect("food");
            apply(&mut kitchen, Command::Put { food: "steak".into(), at: [0.0, 0.0], heap: false });
            let with_food = floor_over(&mut kitchen, 300);
            assert!(with_food[1] < limit && with_food[2] < FIRE_C, "{pan} {power}: {with_food:?}");
        }
    }
}

/// Cooling takes as long as it takes; under the rules of 2013 it is done at once, and the summary states which rules.
#[test]
fn the_rules_of_2013_are_followed_and_labelled() {
    let text = |preset: &str| {
        format!(
            "title = \"T\"\n{preset}\n[pan]\ninitial_c = 220\n[[food]]\nid = \"s\"\nkind = \"beef-lean\"\n\
             [[step]]\nhob_w = 800\n[[step]]\nput = \"s\"\n[[step]]\nafter_s = 240\ncool = \"wet-cloth\"\nfor_s = 1\n[[step]]\nend = true\n"
        )
    };
    let cooked = |preset: &str| {
        let library = library();
        let recipe = Recipe::parse(&text(preset), "t.toml", &library).expect("parses");
        let mut cook = Cook::new(recipe, &library).expect("sets out");
        while cook.stopped().is_none() {
            cook.advance().expect("cooks");
        }
        cook
    };
    let (full, old) = (cooked(""), cooked("preset = \"2013\""));
    let (full_summary, old_summary) = (full.summary(0.0), old.summary(0.0));
    assert_eq!((full_summary.rules, full_summary.title.as_str()), (Rules::Full, "T"));
    assert_eq!((old_summary.rules, old_summary.title.as_str()), (Rules::Paper2013, "T [rules of 2013]"));
    assert!(celsius(old.kitchen.pan_temperature()) <= 121.0);
    assert!(celsius(full.kitchen.pan_temperature()) > 122.0);
    let (f, o) = (&full_summary.foods[0], &old_summary.foods[0]);
    // No juice, no evaporation below boiling, no contraction; the bottom browns in steps.
    assert!(o.water_g.dripped == 0.0 && (o.shape.volume_pct - 100.0).abs() < 1e-9 && f.shape.volume_pct < 99.0);
    assert!((o.core_c.peak - f.core_c.peak).abs() > 1.0, "{} {}", o.core_c.peak, f.core_c.peak);
    assert!(old.kitchen.energy().imbalance.abs() < 1e-6 * old.kitchen.energy().hob);
    let stages = &old.kitchen.pieces()[0].state.browning;
    assert!(stages.iter().all(|b| [0.0, 0.25, 0.5, 0.75, 1.0].contains(b)));
}

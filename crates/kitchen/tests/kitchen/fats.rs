//! Promise: a pan has the fat that was put into it and no other, and a wipe takes it out.

use saute_kitchen::tick::event::EventKind;
use saute_kitchen::{Command, Kitchen, PieceOrder, Refused, celsius, kelvin};

use crate::stove::{apply, library, run};

fn pan(kind: &str, c: f64, oil_g: f64) -> Kitchen {
    Kitchen::with_oil(&library(), kind, kelvin(c), 1e-3 * oil_g).expect("a pan")
}

fn oil_g(kitchen: &Kitchen) -> f64 {
    1e3 * kitchen.pan_state().oil_mass()
}

/// Hottest place of the floor when its oil begins to smoke, on the way up [°C].
fn smokes_at(kind: &str) -> f64 {
    let mut kitchen = pan("stainless-clad-26", 150.0, 0.0);
    apply(&mut kitchen, Command::Oil { kind: Some(kind.into()), mass: 5e-3 });
    apply(&mut kitchen, Command::Hob(900.0));
    while kitchen.events().tally(EventKind::SmokeBegins).count == 0 {
        assert!(kitchen.time_s() < 600.0, "{kind} never smokes");
        run(&mut kitchen, 1.0);
    }
    celsius(kitchen.hottest_temperature())
}

#[test]
fn a_dry_pan_has_its_seasoning_and_nothing_else() {
    for (kind, film) in [
        ("carbon-steel-26", 0.3),
        ("cast-iron-26", 0.3),
        ("carbon-steel-26-nonstick", 0.0),
        ("stainless-clad-26", 0.0),
        ("aluminium-26", 0.0),
    ] {
        assert!((oil_g(&pan(kind, 20.0, 0.0)) - film).abs() < 1e-9, "{kind}");
        assert!((oil_g(&pan(kind, 20.0, 7.0)) - 7.0).abs() < 1e-9, "{kind}");
    }
    let usual = Kitchen::new(&library(), "carbon-steel-26", kelvin(20.0)).expect("a pan");
    assert_eq!(oil_g(&usual), oil_g(&pan("carbon-steel-26", 20.0, 5.0)));
}

#[test]
fn every_oil_smokes_at_its_own_temperature_where_it_is_alone() {
    let oils = library().oils;
    for kind in ["canola", "sunflower", "clarified-butter", "beef-fat", "olive"] {
        let (smoke_c, seen_c) = (oils[kind].heat.smoke_c, smokes_at(kind));
        println!("{kind}: smokes at {smoke_c} °C by its data, does at {seen_c:.0} °C");
        assert!((smoke_c - 1.0..smoke_c + 4.0).contains(&seen_c), "{kind}: {seen_c}");
    }
    assert!(smokes_at("clarified-butter") > smokes_at("canola") + 10.0);
}

#[test]
fn a_wipe_takes_oil_water_and_loose_fond_and_the_books_stay_right() {
    let library = library();
    let mut kitchen = pan("carbon-steel-26", 180.0, 10.0);
    kitchen.add(&library, &PieceOrder { size: [0.06, 0.05, 0.012], coarseness: 2.0, ..steak() }).expect("food");
    apply(&mut kitchen, Command::Hob(1000.0));
    apply(&mut kitchen, Command::Put { food: "steak".into(), at: [0.0; 2], heap: false });
    assert_eq!(kitchen.apply(&Command::Wipe), Err(Refused::FoodToWipe("steak".into())));
    run(&mut kitchen, 60.0);
    apply(&mut kitchen, Command::Rest { food: "steak".into(), on: saute_kitchen::RestOn::Board });
    run(&mut kitchen, 5.0);
    apply(&mut kitchen, Command::Water(0.01));
    run(&mut kitchen, 1.0);
    let of = |kitchen: &Kitchen| {
        let liquids = &kitchen.pan_state().liquids;
        let fond = liquids.fond.dried_kg(&kitchen.pan_model().liquids.bed)[0];
        (
            liquids.oil.total() + liquids.water.total() + liquids.spilled,
            fond,
            fond + liquids.fond.dissolved_kg() + liquids.fond.spilled,
        )
    };
    let (mass, fond, solids) = of(&kitchen);
    let hot = kitchen.pan_temperature();
    apply(&mut kitchen, Command::Wipe);
    let (mass_after, fond_after, solids_after) = of(&kitchen);
    assert!(
        (mass_after - mass).abs() < 1e-12 && (solids_after - solids).abs() < 1e-12,
        "nothing is lost from the books"
    );
    assert!((oil_g(&kitchen) - 0.3).abs() < 1e-9 && kitchen.pan_state().water_mass() == 0.0);
    assert!(fond > 0.0 && (fond_after - 0.5 * fond).abs() < 1e-12);
    assert_eq!(kitchen.pan_temperature(), hot);
    run(&mut kitchen, 30.0);
    let energy = kitchen.energy();
    assert!(energy.imbalance.abs() < 1e-6 * energy.hob, "{energy:?}");
    // A second wipe finds nothing.
    let before = kitchen.pan_state().liquids.spilled;
    apply(&mut kitchen, Command::Wipe);
    assert!((kitchen.pan_state().liquids.spilled - before).abs() < 1e-6);
}

fn steak() -> PieceOrder {
    PieceOrder {
        id: "steak".into(),
        kind: "beef-lean".into(),
        size: [0.10, 0.07, 0.02],
        temperature: kelvin(5.0),
        seed: 1,
        coarseness: 1.0,
        rules: saute_kitchen::food::Rules::Full,
        mesh: saute_kitchen::MeshSize::Default,
        outline: saute_kitchen::OutlineKind::Plain,
    }
}

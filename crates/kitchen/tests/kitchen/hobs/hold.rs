//! Promise: `hold_c` is a thermostat. Whatever stands on the hob, from whatever it begins, the floor reaches the dial.

use saute_kitchen::advice::NoPower;
use saute_kitchen::food::Rules;
use saute_kitchen::{
    Command, EventKind, Holding, Kitchen, Library, MeshSize, OutlineKind, PieceOrder, RestOn, TICK_S, celsius, kelvin,
};

use crate::stove::{apply, library, run};

fn empty_pan(celsius: f64, power: f64) -> Kitchen {
    let mut kitchen = Kitchen::new(&library(), "carbon-steel-26", kelvin(celsius)).expect("pan");
    kitchen.apply(&Command::Hob(power)).expect("power");
    kitchen
}

fn hold(kitchen: &mut Kitchen, celsius: f64) {
    kitchen.apply(&Command::HobHold { temperature: kelvin(celsius), power: 2000.0 }).expect("holds");
}

/// Differences of the floor's mean from 180 °C over so many seconds, the lowest and the highest [K].
fn range(kitchen: &mut Kitchen, seconds: usize) -> [f64; 2] {
    let mut range = [f64::MAX, f64::MIN];
    for _ in 0..seconds {
        run(kitchen, 1.0);
        let difference = celsius(kitchen.pan_temperature()) - 180.0;
        range = [range[0].min(difference), range[1].max(difference)];
    }
    range
}

/// T1–T3 of the validation keep a heavy pan at a temperature: a cold steak costs it little, and for a short time.
#[test]
fn a_hob_holds_a_heavy_pan_at_a_temperature_with_a_steak_in_it() {
    let library = library();
    let mut kitchen = Kitchen::new(&library, "cast-iron-26", kelvin(180.0)).expect("pan");
    let steak = steak([0.12, 0.08, 0.02]);
    kitchen.add(&library, &steak).expect("food");
    hold(&mut kitchen, 180.0);
    assert_eq!(kitchen.hob_holds(), Some(kelvin(180.0)));
    run(&mut kitchen, 120.0);
    kitchen.apply(&Command::Put { food: "steak".into(), at: [0.0, 0.0], heap: false }).expect("put");
    for turn in 0..2 {
        let (first, then) = (range(&mut kitchen, 120), range(&mut kitchen, 180));
        assert!(first[0] > -20.0 && first[1] < 20.0, "side {turn}: {first:?} K");
        assert!(then[0] > -10.0 && then[1] < 10.0, "side {turn}: {then:?} K");
        kitchen.apply(&Command::Flip { food: "steak".into() }).expect("flip");
    }
    let energy = kitchen.energy();
    assert!(energy.imbalance.abs() < 1e-6 * energy.hob, "{energy:?}");
    // A plain power ends it.
    kitchen.apply(&Command::Hob(700.0)).expect("power");
    assert_eq!((kitchen.hob_holds(), kitchen.hob_drawn_w().round()), (None, 700.0));
}

#[test]
fn a_hob_that_holds_a_pan_is_off_above_its_temperature_and_on_below() {
    let mut kitchen = empty_pan(230.0, 0.0);
    run(&mut kitchen, 60.0);
    hold(&mut kitchen, 100.0);
    run(&mut kitchen, 20.0);
    let c = celsius(kitchen.pan_temperature());
    assert!(c > 115.0, "{c} °C");
    assert_eq!((kitchen.energy().hob, kitchen.hob_drawn_w()), (0.0, 0.0));
    assert_eq!(NoPower::of(&kitchen), None, "as hot as it is held");
    hold(&mut kitchen, 230.0);
    run(&mut kitchen, 30.0);
    assert!(kitchen.energy().hob > 10_000.0, "{} J", kitchen.energy().hob);
}

#[test]
fn a_hob_that_holds_a_pan_gives_nothing_to_a_lifted_one_and_goes_on_when_it_is_back() {
    let mut kitchen = empty_pan(150.0, 0.0);
    hold(&mut kitchen, 200.0);
    run(&mut kitchen, 30.0);
    kitchen.apply(&Command::MovePan { at: [0.0, 0.0], lift: 0.05 }).expect("moves");
    run(&mut kitchen, 2.0);
    let lifted = kitchen.energy().hob;
    run(&mut kitchen, 60.0);
    assert_eq!((kitchen.energy().hob, kitchen.hob_drawn_w()), (lifted, 0.0));
    assert_eq!(NoPower::of(&kitchen), Some(NoPower::Lifted));
    kitchen.apply(&Command::MovePan { at: [0.0, 0.0], lift: 0.0 }).expect("moves");
    run(&mut kitchen, 180.0);
    assert!(kitchen.energy().hob > lifted);
    let energy = kitchen.energy();
    assert!(energy.imbalance.abs() < 1e-6 * energy.hob, "{energy:?}");
    let c = celsius(kitchen.pan_temperature());
    assert!((170.0..230.0).contains(&c), "no power was saved up for it: {c} °C");
}

#[test]
fn a_hob_holds_only_temperatures_and_powers_of_its_range() {
    let mut kitchen = empty_pan(20.0, 0.0);
    for (celsius, power) in [(49.0, 2000.0), (231.0, 2000.0), (f64::NAN, 2000.0), (180.0, 9000.0), (180.0, f64::NAN)] {
        let refused = kitchen.apply(&Command::HobHold { temperature: kelvin(celsius), power });
        assert!(refused.is_err(), "{celsius} °C, {power} W");
    }
    assert_eq!((kitchen.hob_holds(), kitchen.hob_w()), (None, 0.0));
}

/// A steak of a size [m] from the refrigerator.
pub(crate) fn steak(size: [f64; 3]) -> PieceOrder {
    PieceOrder {
        id: "steak".into(),
        kind: "beef-lean".into(),
        size,
        temperature: kelvin(5.0),
        seed: 1,
        coarseness: 2.5,
        rules: Rules::Full,
        mesh: MeshSize::Default,
        outline: OutlineKind::Plain,
    }
}

const PANS: [&str; 5] = ["aluminium-26", "carbon-steel-26", "cast-iron-26", "cast-iron-grill-26", "stainless-clad-26"];

/// What is in the pan from the start.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Filled {
    Nothing,
    /// Oil [kg].
    Oil(f64),
    /// A litre of water.
    Water,
}

#[derive(Clone, Copy, Debug)]
enum Begins {
    Cold,
    /// After full power until the floor has the temperature of the dial.
    AfterFullPower,
}

fn filled(library: &Library, pan: &str, with: Filled) -> Kitchen {
    let mut kitchen = Kitchen::new(library, pan, kelvin(20.0)).expect("a pan");
    match with {
        Filled::Nothing => {}
        Filled::Oil(mass) => apply(&mut kitchen, Command::Oil { kind: None, mass }),
        Filled::Water => apply(&mut kitchen, Command::Water(1.0)),
    }
    kitchen
}

/// Mean temperature of what is to have the dial's temperature: water where it is in the pan, else floor or oil [°C].
fn judged(kitchen: &Kitchen, with: Filled) -> f64 {
    let state = kitchen.pan_state();
    match with {
        Filled::Water if state.water_mass() > 0.01 => {
            celsius(saute_kitchen::food::ZERO_C + state.liquids.water.stored() / (state.water_mass() * 4190.0))
        }
        Filled::Oil(_) => {
            let oil = &state.liquids.oil.mass;
            let sum: f64 = oil.iter().zip(&state.temperature).map(|(mass, t)| mass * t).sum();
            celsius(sum / oil.iter().sum::<f64>())
        }
        _ => celsius(kitchen.pan_temperature()),
    }
}

/// Seconds until full power, cut only where a place of the pan is 50 K over the dial, has brought what is judged there.
fn full_power(kitchen: &mut Kitchen, with: Filled, dial: f64) -> f64 {
    let from = kitchen.time_s();
    while judged(kitchen, with) < dial {
        let is_hot = celsius(kitchen.hottest_temperature()) > dial + 50.0;
        apply(kitchen, Command::Hob(if is_hot { 0.0 } else { 2000.0 }));
        kitchen.step();
        assert!(kitchen.time_s() - from < 3600.0, "it gets there");
    }
    kitchen.time_s() - from
}

/// Lowest and highest of what is judged less the dial in a span, and the hottest place less the dial [K].
#[derive(Clone, Copy, Debug)]
struct Span {
    lowest: f64,
    highest: f64,
    hottest: f64,
}

fn span(kitchen: &mut Kitchen, with: Filled, dial: f64, seconds: f64) -> Span {
    let mut found = Span { lowest: f64::MAX, highest: f64::MIN, hottest: f64::MIN };
    for _ in 0..(seconds / TICK_S).round() as usize {
        kitchen.step();
        let now = judged(kitchen, with) - dial;
        found.lowest = found.lowest.min(now);
        found.highest = found.highest.max(now);
        found.hottest = found.hottest.max(celsius(kitchen.hottest_temperature()) - dial);
    }
    found
}

/// True if a span stays so near the dial [K].
fn keeps(found: Span, within: f64) -> bool {
    found.lowest >= -within && found.highest <= within
}

/// What a pan on the hob is like from the time at which the dial's promise begins, `wait` after full power alone would have
/// reached it [s]; before that it overshoots by no more than 8 K, and no place of it is 50 K over the dial.
fn held(library: &Library, pan: &str, (with, dial, wait): (Filled, f64, f64), begins: Begins) -> Span {
    let reached = full_power(&mut filled(library, pan, with), with, dial);
    let mut kitchen = filled(library, pan, with);
    let before = match begins {
        Begins::Cold => reached + wait,
        Begins::AfterFullPower => {
            full_power(&mut kitchen, with, dial);
            wait
        }
    };
    hold(&mut kitchen, dial);
    let first = span(&mut kitchen, with, dial, before);
    let after_cold = matches!(begins, Begins::Cold);
    assert!(first.highest <= 8.0, "{pan} {dial} {with:?} {begins:?}: {first:?}");
    assert!(!after_cold || first.hottest <= 50.0, "{pan} {dial} {with:?}: {first:?}");
    span(&mut kitchen, with, dial, 120.0)
}

#[test]
fn an_empty_or_oiled_pan_has_the_temperature_of_the_dial() {
    let library = library();
    for pan in library.pans.keys() {
        let plain = PANS.contains(&pan.as_str());
        let dials: &[f64] = if plain { &[140.0, 180.0, 220.0] } else { &[180.0] };
        for dial in dials {
            for (with, begins) in [(Filled::Nothing, Begins::Cold), (Filled::Oil(0.01), Begins::AfterFullPower)] {
                let found = held(&library, pan, (with, *dial, 60.0), begins);
                assert!(keeps(found, 5.0), "{pan} {dial} {with:?} {begins:?}: {found:?}");
            }
        }
    }
}

#[test]
fn a_litre_of_oil_has_the_temperature_of_the_dial() {
    let library = library();
    for pan in PANS {
        for (dial, begins) in [(140.0, Begins::AfterFullPower), (180.0, Begins::Cold)] {
            let found = held(&library, pan, (Filled::Oil(0.9), dial, 120.0), begins);
            assert!(keeps(found, 5.0), "{pan} {dial} {begins:?}: {found:?}");
        }
    }
}

#[test]
fn a_litre_of_water_has_the_temperature_of_the_dial_below_boiling() {
    let library = library();
    for pan in PANS {
        for dial in [60.0, 80.0, 95.0] {
            let found = held(&library, pan, (Filled::Water, dial, 120.0), Begins::Cold);
            assert!(keeps(found, 3.0), "{pan} {dial}: {found:?}");
        }
    }
}

/// The hob states that water boils, and that the pan is as hot as it is set once it has gone.
#[test]
fn a_pan_that_boils_dry_does_not_shoot_over() {
    let library = library();
    for pan in ["aluminium-26", "cast-iron-26"] {
        let mut kitchen = filled(&library, pan, Filled::Water);
        hold(&mut kitchen, 180.0);
        run(&mut kitchen, 600.0);
        assert_eq!(kitchen.holding(), Some(Holding::Boils), "{pan}");
        while kitchen.pan_state().water_mass() > 0.0 {
            kitchen.step();
            assert!(kitchen.time_s() < 3600.0, "{pan} boils dry");
        }
        let first = span(&mut kitchen, Filled::Nothing, 180.0, 60.0);
        assert!(first.highest <= 25.0, "{pan}: {first:?}");
        let then = span(&mut kitchen, Filled::Nothing, 180.0, 120.0);
        assert!(keeps(then, 5.0), "{pan}: {then:?}");
        assert_eq!(kitchen.holding(), Some(Holding::Reached), "{pan}");
        let told = [EventKind::BoilsBelowDial, EventKind::DialReached].map(|kind| kitchen.events().tally(kind).count);
        assert_eq!(told, [1, 1], "{pan}: each is said once");
    }
}

/// A steak of 25 mm from the refrigerator, in the middle or 35 mm off, turned at four minutes.
#[test]
fn a_cold_steak_costs_the_floor_little_and_for_a_short_time() {
    let library = library();
    for (i, pan) in PANS.into_iter().enumerate() {
        for (j, dial) in [140.0, 180.0, 220.0].into_iter().enumerate() {
            let x = if (i + j) % 2 == 0 { 0.0 } else { 0.035 };
            let before = full_power(&mut filled(&library, pan, Filled::Nothing), Filled::Nothing, dial) + 60.0;
            let mut kitchen = filled(&library, pan, Filled::Nothing);
            kitchen.add(&library, &steak([0.12, 0.08, 0.025])).expect("food");
            hold(&mut kitchen, dial);
            span(&mut kitchen, Filled::Nothing, dial, before);
            for command in [
                Command::Put { food: "steak".into(), at: [x, 0.0], heap: false },
                Command::Flip { food: "steak".into() },
            ] {
                apply(&mut kitchen, command);
                let mut next = |seconds| span(&mut kitchen, Filled::Nothing, dial, seconds);
                let (dip, then) = (next(60.0), next(180.0));
                assert!(dip.lowest >= -15.0, "{pan} {dial} {x}: {dip:?}");
                assert!(keeps(then, 8.0), "{pan} {dial} {x}: {then:?}");
            }
            apply(&mut kitchen, Command::Rest { food: "steak".into(), on: RestOn::Board });
            let out = span(&mut kitchen, Filled::Nothing, dial, 60.0);
            assert!(out.highest <= 10.0, "{pan} {dial} {x}: {out:?}");
        }
    }
}

#[test]
fn a_class_of_pan_that_is_a_fifth_wrong_costs_at_most_five_kelvin() {
    let right = library();
    for pan in PANS {
        let mean = |library: &Library| {
            let found = held(library, pan, (Filled::Nothing, 180.0, 60.0), Begins::Cold);
            0.5 * (found.lowest + found.highest)
        };
        let wanted = mean(&right);
        for share in [0.8, 1.2] {
            let mut wrong = library();
            wrong.hob.hold.as_mut().expect("induction").class_share = share;
            let found = mean(&wrong);
            assert!((found - wanted).abs() <= 5.0, "{pan} × {share}: {found} for {wanted} K");
        }
    }
}

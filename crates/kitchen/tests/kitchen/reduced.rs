//! Promise: a kitchen on coarse meshes begins with the heat and the liquids of the present one, goes on nearly as it does,
//! and turns pieces over and takes them out.
#![allow(clippy::unwrap_used)]

use saute_kitchen::food::Rules;
use saute_kitchen::reduced::{LAPSE_S, ReducedKitchen, Reductions};
use saute_kitchen::{Command, Kitchen, Library, MeshSize, OutlineKind, PieceOrder, Place, Refused, RestOn, kelvin};

fn library() -> Library {
    Library::embedded().unwrap()
}

fn order() -> PieceOrder {
    PieceOrder {
        id: "steak".into(),
        kind: "beef-lean".into(),
        size: [0.11, 0.075, 0.018],
        temperature: kelvin(8.0),
        seed: 5,
        coarseness: 1.4,
        rules: Rules::Full,
        mesh: MeshSize::Default,
        outline: OutlineKind::Natural,
    }
}

fn put() -> Command {
    Command::Put { food: "steak".into(), at: [0.01, 0.0], heap: false }
}

/// A steak after a minute and a half on one face.
fn frying(library: &Library) -> Kitchen {
    let mut kitchen = Kitchen::new(library, "stainless-clad-26", kelvin(200.0)).unwrap();
    kitchen.add(library, &order()).unwrap();
    kitchen.apply(&Command::Hob(900.0)).unwrap();
    kitchen.apply(&Command::Oil { kind: None, mass: 0.004 }).unwrap();
    kitchen.apply(&put()).unwrap();
    run(&mut kitchen, 90.0);
    kitchen
}

fn run(kitchen: &mut Kitchen, for_s: f64) {
    (0..(for_s / saute_kitchen::TICK_S).round() as u64).for_each(|_| kitchen.step());
}

fn run_reduced(kitchen: &mut ReducedKitchen, for_s: f64) {
    (0..(for_s / LAPSE_S).round() as u64).for_each(|_| kitchen.step());
}

fn flip() -> Command {
    Command::Flip { food: "steak".into() }
}

#[test]
fn heat_oil_and_water_of_the_present_are_carried_over() {
    let kitchen = frying(&library());
    let reduced = kitchen.reduced(&mut Reductions::default()).unwrap();
    let (fine, coarse) = (kitchen.pan_state(), reduced.kitchen().pan_state());
    let close = |a: f64, b: f64, relative: f64| assert!((a - b).abs() <= relative * b.abs(), "{a} instead of {b}");
    close(coarse.oil_mass(), fine.oil_mass(), 1e-12);
    close(coarse.water_mass(), fine.water_mass(), 1e-12);
    close(coarse.ring_shares.iter().sum(), fine.ring_shares.iter().sum(), 1e-12);
    let stored = |kitchen: &Kitchen| kitchen.pan_model().stored(kitchen.pan_state());
    close(stored(reduced.kitchen()), stored(&kitchen), 0.02);
    assert!((reduced.kitchen().pan_temperature() - kitchen.pan_temperature()).abs() < 3.0);
    let [was, is] = [&kitchen, reduced.kitchen()].map(|k| k.piece("steak").unwrap().state.total_enthalpy());
    close(is, was, 1e-12);
    assert_eq!(reduced.kitchen().time_s(), kitchen.time_s());
}

#[test]
fn it_goes_on_nearly_as_the_kitchen_does() {
    let library = library();
    let commands = [None, Some(flip()), Some(Command::Rest { food: "steak".into(), on: RestOn::Board })];
    for command in commands {
        let mut kitchen = frying(&library);
        let mut reduced = kitchen.reduced(&mut Reductions::default()).unwrap();
        if let Some(command) = &command {
            kitchen.apply(command).unwrap();
            reduced.apply(command).unwrap();
        }
        run(&mut kitchen, 60.0);
        run_reduced(&mut reduced, 60.0);
        let [full, coarse] = [&kitchen, reduced.kitchen()].map(|k| k.piece("steak").unwrap());
        assert_eq!(coarse.upside_down(), full.upside_down(), "{command:?}");
        assert_eq!(coarse.place.name(), full.place.name(), "{command:?}");
        assert!((coarse.core() - full.core()).abs() < 1.5, "{command:?}: {} {}", coarse.core(), full.core());
        let browning = |p: &saute_kitchen::Piece| p.model.face_browning(&p.state, p.up());
        assert!((browning(coarse) - browning(full)).abs() < 0.1, "{command:?}");
    }
}

#[test]
fn a_flipped_piece_lies_on_its_other_face_and_one_that_is_out_is_on_the_board() {
    let kitchen = frying(&library());
    let mut reduced = kitchen.reduced(&mut Reductions::default()).unwrap();
    let mut out = reduced.clone();
    reduced.apply(&flip()).unwrap();
    assert_eq!(reduced.kitchen().piece("steak").unwrap().place, Place::Held);
    assert_eq!(reduced.apply(&flip()), Err(Refused::NotInPan("steak".into())));
    run_reduced(&mut reduced, 5.0);
    let piece = reduced.kitchen().piece("steak").unwrap();
    assert!(piece.in_pan() && piece.upside_down() && piece.flipped_at().is_some());
    assert!(piece.pan_force() > 0.5, "{} N", piece.pan_force());
    out.apply(&Command::Rest { food: "steak".into(), on: RestOn::Rack }).unwrap();
    run_reduced(&mut out, 5.0);
    assert_eq!(out.kitchen().piece("steak").unwrap().place, Place::Rest(RestOn::Rack));
    assert!(matches!(out.apply(&Command::Flip { food: "egg".into() }), Err(Refused::NoSuchFood(_))));
}

/// A thick steak that is turned once loses more than a millimetre of its thickness on its second face: it sinks onto the pan
/// as it does so, as its body does on the full mesh.
#[test]
fn a_piece_that_grows_thinner_stays_on_the_pan() {
    let library = library();
    let mut kitchen = Kitchen::new(&library, "carbon-steel-26", kelvin(220.0)).unwrap();
    kitchen.add(&library, &PieceOrder { size: [0.11, 0.075, 0.03], ..order() }).unwrap();
    for command in [Command::Hob(600.0), Command::Oil { kind: None, mass: 0.005 }, put()] {
        kitchen.apply(&command).unwrap();
    }
    run(&mut kitchen, 1.0);
    let mut reduced = kitchen.reduced(&mut Reductions::default()).unwrap();
    run_reduced(&mut reduced, 420.0);
    reduced.apply(&flip()).unwrap();
    run_reduced(&mut reduced, 5.0);
    for minute in 0..10 {
        let piece = reduced.kitchen().piece("steak").unwrap();
        assert!(piece.is_near_pan(), "after {minute} min, {} °C", piece.face(true) - kelvin(0.0));
        run_reduced(&mut reduced, 60.0);
    }
}

/// Two runs from one present agree to the last bit, and leave it as it is.
#[test]
fn it_is_a_pure_function_of_the_present() {
    let kitchen = frying(&library());
    let before = kitchen.state_hash();
    let mut known = Reductions::default();
    let ends = [0, 1].map(|_| {
        let mut reduced = kitchen.reduced(&mut known).unwrap();
        reduced.apply(&flip()).unwrap();
        run_reduced(&mut reduced, 30.0);
        reduced.kitchen().state_hash()
    });
    assert_eq!(ends[0], ends[1]);
    assert_eq!(kitchen.state_hash(), before);
}

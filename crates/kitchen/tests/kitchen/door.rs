//! Promise: whatever number is in a command, the kitchen carries it out within its ranges or refuses it and stays as it was: no
//! panic, no value that is no number, no frozen food, and a closed energy balance.

use glam::{DQuat, DVec3};
use saute_kitchen::dynamics::{Pose, Tool};
use saute_kitchen::food::Rules;
use saute_kitchen::piece::memory::{Load, NoRoom};
use saute_kitchen::{Command, Kitchen, MeshSize, OutlineKind, PieceOrder, Refused, kelvin};

use crate::stove::{library, run};

/// What a file, a link or a device may hold in the place of a number.
const EVIL: [f64; 10] =
    [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e308, -1e308, 0.0, -1.0, 1e9, -1e-300, f64::from_bits(1)];
/// How long is cooked after each command [s].
const AFTER_S: f64 = 1.0;

fn kitchen() -> Kitchen {
    let library = library();
    let mut kitchen = Kitchen::new(&library, "carbon-steel-26", kelvin(180.0)).expect("pan");
    let order = PieceOrder {
        id: "steak".into(),
        kind: "beef-lean".into(),
        size: [0.06, 0.05, 0.015],
        temperature: kelvin(5.0),
        seed: 1,
        coarseness: 3.0,
        rules: Rules::Full,
        mesh: MeshSize::Default,
        outline: OutlineKind::Plain,
    };
    kitchen.add(&library, &order).expect("food");
    kitchen.apply(&Command::Put { food: "steak".into(), at: [0.0; 2], heap: false }).expect("puts");
    run(&mut kitchen, 1.0);
    kitchen
}

/// Every number of every command, in its place.
fn commands(v: f64) -> Vec<Command> {
    let food = || "steak".to_owned();
    let pose = |position, rotation| Pose { position, rotation };
    let (up, here) = (DQuat::IDENTITY, DVec3::new(0.0, 0.0, 0.1));
    let turned = [DQuat::from_xyzw(v, 0.0, 0.0, 1.0), DQuat::from_xyzw(v, v, v, v), DQuat::from_xyzw(0.0, 0.0, v, 0.0)];
    let mut all = vec![
        Command::Hob(v),
        Command::HobHold { temperature: v, power: 1000.0 },
        Command::HobHold { temperature: kelvin(180.0), power: v },
        Command::Move { food: food(), to: [v, 0.0] },
        Command::Move { food: food(), to: [0.0, v] },
        Command::Press { food: food(), newtons: v, for_s: 0.5 },
        Command::Press { food: food(), newtons: 10.0, for_s: v },
        Command::MovePan { at: [v, 0.0], lift: 0.0 },
        Command::MovePan { at: [0.0; 2], lift: v },
        Command::Cool { for_s: v },
        Command::Toss { height: v },
        Command::Shake { amplitude: v, hz: 3.0, for_s: 0.5 },
        Command::Shake { amplitude: 0.02, hz: v, for_s: 0.5 },
        Command::Shake { amplitude: 0.02, hz: 3.0, for_s: v },
        Command::Tilt { angle: v, towards: 0.0 },
        Command::Tilt { angle: 0.2, towards: v },
        Command::Oil { kind: None, mass: v },
        Command::Butter(v),
        Command::Water(v),
        Command::HoldPan { pose: pose(DVec3::splat(v), up) },
    ];
    all.extend(turned.map(|rotation| Command::HoldPan { pose: pose(here, rotation) }));
    for tool in [Tool::Turner, Tool::Tongs] {
        all.push(Command::Lead { tool, to: pose(DVec3::splat(v), up), grip: None });
        all.extend(turned.map(|rotation| Command::Lead { tool, to: pose(here, rotation), grip: Some(food()) }));
    }
    all
}

/// Commands to food that is not in the pan.
fn commands_beside(v: f64) -> Vec<Command> {
    let food = || "steak".to_owned();
    let mut all = vec![Command::Halve { food: food(), at: v }];
    for heap in [false, true] {
        all.push(Command::Put { food: food(), at: [v, 0.0], heap });
        all.push(Command::Put { food: food(), at: [0.0, v], heap });
    }
    all
}

fn tried(kitchen: &Kitchen, command: &Command) {
    let mut kitchen = kitchen.clone();
    let before = kitchen.to_bytes();
    if kitchen.apply(command).is_err() {
        assert_eq!(kitchen.to_bytes(), before, "{command:?} was refused and changed something");
    }
    run(&mut kitchen, AFTER_S);
    let energy = kitchen.energy();
    let stored = energy.pan_stored.abs() + energy.food_stored.abs() + energy.hob;
    assert!(energy.imbalance.abs() < 1e-6 * stored, "{command:?}: {energy:?}");
    for piece in kitchen.pieces() {
        assert!(piece.pose.is_finite(), "{command:?}: {:?}", piece.pose);
        assert!(piece.state.temperature.iter().all(|t| (200.0..900.0).contains(t)), "{command:?}");
    }
    assert!(kitchen.pan_state().temperature.iter().all(|t| (200.0..900.0).contains(t)), "{command:?}");
}

#[test]
fn no_number_in_a_command_breaks_the_kitchen() {
    let in_pan = kitchen();
    let mut on_board = in_pan.clone();
    on_board.apply(&Command::Rest { food: "steak".into(), on: saute_kitchen::RestOn::Board }).expect("rests");
    run(&mut on_board, 6.0);
    for v in EVIL {
        commands(v).iter().for_each(|command| tried(&in_pan, command));
        commands_beside(v).iter().for_each(|command| tried(&on_board, command));
    }
}

#[test]
fn what_is_beyond_a_range_is_refused_with_the_range_and_its_ends_are_taken() {
    let mut kitchen = kitchen();
    let refused = kitchen.apply(&Command::Toss { height: -1.0 }).expect_err("below the pan");
    assert_eq!(refused.to_string(), "toss.height_mm may be 0 to 500");
    let refused = kitchen.apply(&Command::Shake { amplitude: f64::NAN, hz: 3.0, for_s: 5.0 }).expect_err("no number");
    assert_eq!(refused.to_string(), "shake.amplitude_mm may be 0 to 100");
    for height in [0.0, 0.5] {
        assert_eq!(kitchen.clone().apply(&Command::Toss { height }), Ok(()));
    }
    for degrees in [-180.0_f64, 180.0] {
        let tilt = Command::Tilt { angle: degrees.to_radians(), towards: (-360.0_f64).to_radians() };
        assert_eq!(kitchen.clone().apply(&tilt), Ok(()));
    }
}

/// A piece of a steak's kind, as someone may order it.
fn large_steak(id: usize, coarseness: f64) -> PieceOrder {
    PieceOrder {
        id: format!("p{id}"),
        kind: "beef-lean".into(),
        size: [0.19, 0.19, 0.06],
        temperature: kelvin(5.0),
        seed: id as u64,
        coarseness,
        rules: Rules::Full,
        mesh: MeshSize::Default,
        outline: OutlineKind::Plain,
    }
}

#[test]
fn food_beyond_the_memory_of_a_kitchen_is_refused_before_it_is_built_with_what_would_fit() {
    let library = library();
    let food = &library.foods["beef-lean"];
    let fits_at = |coarseness, count| Load::default().add("p1", &large_steak(1, coarseness).spec(), food, count);
    let fits = |count| fits_at(1.0, count);
    let refused = fits(200).expect_err("200 steaks of two kilograms");
    let NoRoom::TooMuch { excess, .. } = refused.clone() else { panic!("{refused}") };
    assert_eq!((excess.asked, excess.before), (200, 0));
    assert!((3..12).contains(&excess.fit), "{excess}");
    assert!(excess.to_string().contains(&format!("at most {} fit", excess.fit)), "{excess}");
    assert_eq!(fits(excess.fit), Ok(()));
    assert!(fits(excess.fit + 1).is_err());
    assert_eq!(fits_at(0.5, 1), Ok(()), "one of the finest mesh is judged, not built");
}

#[test]
fn pieces_that_are_added_one_after_another_are_counted_together() {
    let library = library();
    let mut kitchen = Kitchen::new(&library, "carbon-steel-26", kelvin(20.0)).expect("pan");
    let refusal = (0..100).find_map(|id| kitchen.add(&library, &large_steak(id, 2.0)).err());
    let refusal = refusal.expect("a hundred large steaks are too many").to_string();
    let here = kitchen.pieces().len();
    assert!(refusal.contains(&format!("none fits beside the {here} before")), "{refusal}");
    assert!(here > 7, "a coarser mesh gives room: {here}");
}

#[test]
fn a_size_that_is_no_number_is_refused_before_its_mesh_is_judged() {
    let library = library();
    let mut kitchen = Kitchen::new(&library, "carbon-steel-26", kelvin(20.0)).expect("pan");
    for size in [f64::NAN, f64::INFINITY, 1e308, 0.0, -1.0] {
        let order = PieceOrder { size: [0.1, 0.1, size], ..large_steak(1, 1.0) };
        assert!(kitchen.add(&library, &order).is_err(), "{size}");
    }
}

/// A hand at its reach drops no food, and a pose that is none leaves it where it was.
#[test]
fn a_pose_out_of_reach_is_held_at_the_edge_and_one_that_is_none_is_dropped() {
    let mut kitchen = kitchen();
    kitchen.apply(&Command::HoldPan { pose: Pose::at(0.1, 0.0, 0.1) }).expect("in reach");
    let good = kitchen.held_pan();
    assert_eq!(kitchen.apply(&Command::HoldPan { pose: Pose::at(f64::NAN, 0.0, 0.1) }), Err(Refused::NoPose));
    assert_eq!(kitchen.held_pan(), good);
    run(&mut kitchen, 2.0);
    kitchen.apply(&Command::HoldPan { pose: Pose::at(3.0, 0.0, 0.1) }).expect("held at the edge");
    assert!((0.49..0.51).contains(&kitchen.held_pan().position.x), "{:?}", kitchen.held_pan());
    run(&mut kitchen, 3.0);
    assert!(kitchen.piece("steak").expect("is there").in_pan());
}

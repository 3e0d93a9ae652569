//! Promises of the rigid bodies: rest, no sinking, no tunnelling, flips and tosses through forces alone.

use saute_kitchen::dynamics::{Pose, RIGID_S};
use saute_kitchen::food::GRAVITY;
use saute_kitchen::hands::FoodVelocities;
use saute_kitchen::{
    Command, FRAME_S, Kitchen, Library, MeshSize, OutlineKind, PieceOrder, Place, TICK_S, food::Rules, kelvin,
};

use crate::stove::library;

fn order(id: &str, kind: &str, library: &Library, seed: u64) -> PieceOrder {
    let food = &library.foods[kind];
    PieceOrder {
        id: id.into(),
        kind: kind.into(),
        size: food.form.extent(&food.size.default_mm).expect("a size").map(|mm| mm * 1e-3),
        temperature: kelvin(20.0),
        seed,
        coarseness: 1.0,
        mesh: MeshSize::Paper2013,
        rules: Rules::Full,
        outline: OutlineKind::Plain,
    }
}

fn kitchen(foods: &[(&str, usize)]) -> (Kitchen, Vec<String>) {
    let library = library();
    let mut kitchen = Kitchen::new(&library, "carbon-steel-26", kelvin(20.0)).expect("a pan");
    let mut ids = Vec::new();
    for (kind, count) in foods {
        for i in 0..*count {
            let id = format!("{kind}{i}");
            kitchen.add(&library, &order(&id, kind, &library, i as u64 + 1)).expect("a piece");
            ids.push(id);
        }
    }
    (kitchen, ids)
}

fn put_heaped(kitchen: &mut Kitchen, ids: &[String]) {
    for (i, id) in ids.iter().enumerate() {
        let angle = 2.399_963 * i as f64;
        let radius = 0.06 * ((i as f64 + 0.5) / ids.len() as f64).sqrt();
        let at = [radius * angle.cos(), radius * angle.sin()];
        kitchen.apply(&Command::Put { food: id.clone(), at, heap: true }).expect("put");
        kitchen.step();
    }
}

fn fastest(kitchen: &Kitchen) -> f64 {
    let speed = |p: &saute_kitchen::Piece| kitchen.world().velocity(p.key).expect("a body").0.length();
    kitchen.pieces().iter().map(speed).fold(0.0, f64::max)
}

#[test]
fn forty_pieces_come_to_rest_within_two_seconds_and_sink_nowhere() {
    let (mut kitchen, ids) = kitchen(&[("carrot-coin", 15), ("leek-ring", 10), ("shrimp", 15)]);
    put_heaped(&mut kitchen, &ids);
    (0..20).for_each(|_| kitchen.step());
    let (mut speed, mut depth) = (0.0f64, 0.0f64);
    for _ in 0..20 {
        kitchen.step();
        (speed, depth) = (speed.max(fastest(&kitchen)), depth.max(kitchen.world().deepest_overlap()));
    }
    println!("fastest {speed:.2e} m/s, deepest {:.3} mm", 1e3 * depth);
    assert!(fastest(&kitchen) < 1e-3, "{} m/s", fastest(&kitchen));
    assert!(kitchen.world().deepest_overlap() < 0.5e-3);
    assert!(kitchen.pieces().iter().all(saute_kitchen::Piece::in_pan));
}

fn settle(kitchen: &mut Kitchen) {
    for _ in 0..200 {
        kitchen.step();
        if !kitchen.busy() && kitchen.world().is_settled() {
            return;
        }
    }
}

#[test]
fn a_flip_turns_every_food_over_where_it_lies() {
    for kind in ["beef-lean", "beef-patty", "shrimp", "carrot-coin", "carrot-stick", "leek-ring"] {
        let (mut kitchen, ids) = kitchen(&[(kind, 1)]);
        kitchen.apply(&Command::Put { food: ids[0].clone(), at: [0.0; 2], heap: false }).expect("put");
        settle(&mut kitchen);
        let before = kitchen.pieces()[0].pose;
        kitchen.apply(&Command::Flip { food: ids[0].clone() }).expect("flip");
        let mut previous = before;
        while kitchen.busy() || !kitchen.world().is_settled() {
            kitchen.advance_frame();
            let now = kitchen.pieces()[0].pose;
            // Nothing jumps: a frame moves a piece by what its speed allows.
            assert!((now.position - previous.position).length() < 2.0 / 60.0, "{kind} jumped");
            previous = now;
            assert!(kitchen.time_s() < 30.0, "{kind} never settles {:?}", now);
        }
        let after = &kitchen.pieces()[0];
        println!(
            "{kind} {:?} -> {:?} up {:?} t {}",
            before.position,
            after.pose.position,
            after.up(),
            kitchen.time_s()
        );
        assert!(after.up()[2] < -0.9, "{kind} {:?}", after.up());
        assert!((after.pose.position - before.position).truncate().length() < 0.02, "{kind}");
        assert!(after.in_pan());
    }
}

#[test]
fn a_rest_carries_the_food_to_the_board_and_back() {
    let (mut kitchen, ids) = kitchen(&[("beef-lean", 1)]);
    kitchen.apply(&Command::Put { food: ids[0].clone(), at: [0.0; 2], heap: false }).expect("put");
    settle(&mut kitchen);
    kitchen.apply(&Command::Rest { food: ids[0].clone(), on: Default::default() }).expect("rest");
    settle(&mut kitchen);
    println!("{} s {:?} {:?}", kitchen.time_s(), kitchen.pieces()[0].place, kitchen.pieces()[0].pose);
    assert!(matches!(kitchen.pieces()[0].place, Place::Rest(_)));
    kitchen.apply(&Command::Put { food: ids[0].clone(), at: [0.0; 2], heap: false }).expect("put back");
    settle(&mut kitchen);
    assert!(kitchen.pieces()[0].in_pan());
    let _ = (Pose::default(), RIGID_S, TICK_S);
}

/// A cook drops sticks: they point this way and that, by their seeds. Plain pieces lie alike.
#[test]
fn natural_sticks_lie_turned_by_at_most_what_their_file_states_and_plain_ones_are_not_turned() {
    let library = library();
    let most = library.foods["carrot-stick"].natural.as_ref().expect("a natural form").turned_deg.to_radians();
    let turns = |outline| {
        let mut kitchen = Kitchen::new(&library, "carbon-steel-26", kelvin(20.0)).expect("a pan");
        let ids: Vec<String> = (1..=5).map(|seed| format!("stick{seed}")).collect();
        for (id, seed) in ids.iter().zip(1..) {
            let order = PieceOrder { mesh: MeshSize::Default, outline, ..order(id, "carrot-stick", &library, seed) };
            kitchen.add(&library, &order).expect("a piece");
        }
        let places = kitchen.free_places(&ids, [0.0; 2]);
        assert_eq!(places.len(), ids.len());
        for (id, at) in ids.iter().zip(places) {
            kitchen.apply(&Command::Put { food: id.clone(), at, heap: false }).expect("put");
        }
        let along = |p: &saute_kitchen::Piece| p.pose.rotation * glam::DVec3::X;
        kitchen.pieces().iter().map(|p| along(p).y.atan2(along(p).x)).collect::<Vec<f64>>()
    };
    assert!(turns(OutlineKind::Plain).iter().all(|turn| *turn == 0.0));
    let turned = turns(OutlineKind::Natural);
    assert!(turned.iter().all(|turn| turn.abs() <= most), "{turned:?}");
    let spread = turned.iter().fold(0.0, |most: f64, turn| most.max((turn - turned[0]).abs()));
    assert!(spread > 0.3 * most, "{turned:?}");
}

#[test]
fn a_toss_turns_most_foods_over_and_loses_none() {
    for (foods, least) in [(("carrot-coin", 11), 0.6), (("shrimp", 8), 0.3), (("beef-patty", 1), 1.0)] {
        let (mut kitchen, ids) = kitchen(&[foods]);
        let places = kitchen.free_places(&ids, [0.0; 2]);
        for (id, at) in ids.iter().zip(places) {
            kitchen.apply(&Command::Put { food: id.clone(), at, heap: false }).expect("put");
        }
        settle(&mut kitchen);
        let before: Vec<f64> = kitchen.pieces().iter().map(|p| p.up()[2]).collect();
        kitchen.apply(&Command::Toss { height: 0.25 }).expect("toss");
        settle(&mut kitchen);
        let turned = kitchen.pieces().iter().zip(&before).filter(|(p, up)| p.up()[2] * **up < 0.0).count();
        println!("{foods:?}: {turned} of {} turned over", before.len());
        assert!(kitchen.pieces().iter().all(saute_kitchen::Piece::in_pan), "{foods:?}");
        assert!(turned as f64 >= least * before.len() as f64, "{foods:?}: {turned}");
    }
}

/// A toss that is ordered while the turner is below the food begins afterwards: both happen, and nothing flies from the blade.
#[test]
fn a_toss_waits_for_the_turner() {
    for ticks in [1, 8, 15, 25] {
        let (mut kitchen, ids) = kitchen(&[("beef-patty", 1)]);
        kitchen.apply(&Command::Put { food: ids[0].clone(), at: [0.0; 2], heap: false }).expect("put");
        settle(&mut kitchen);
        let up = kitchen.pieces()[0].up()[2];
        kitchen.apply(&Command::Flip { food: ids[0].clone() }).expect("flip");
        (0..ticks).for_each(|_| kitchen.step());
        kitchen.apply(&Command::Toss { height: 0.25 }).expect("toss");
        let stands = kitchen.world().motion.pose;
        while kitchen.hand().is_active() {
            assert_eq!(kitchen.world().motion.pose, stands, "the pan stands while the turner is in it");
            kitchen.step();
        }
        assert!(kitchen.pieces()[0].up()[2] * up < 0.0, "turned by the turner, {ticks} ticks");
        settle(&mut kitchen);
        assert!(
            kitchen.pieces()[0].in_pan() && kitchen.pieces()[0].up()[2] * up > 0.0,
            "and by the toss, {ticks} ticks"
        );
    }
}

/// Under what is too heavy for a hand the turner fails, reports it, and the food stays as it lies.
#[test]
fn a_blocked_turner_fails_to_flip() {
    let library = library();
    let mut kitchen = Kitchen::new(&library, "carbon-steel-26", kelvin(20.0)).expect("a pan");
    let mut ids = vec!["patty".to_owned()];
    kitchen.add(&library, &order("patty", "beef-patty", &library, 1)).expect("a patty");
    for i in 0..3 {
        let id = format!("steak{i}");
        let steak = PieceOrder { size: [0.15, 0.11, 0.04], ..order(&id, "beef-lean", &library, i) };
        kitchen.add(&library, &steak).expect("a steak");
        ids.push(id);
    }
    for (i, id) in ids.iter().enumerate() {
        kitchen.apply(&Command::Put { food: id.clone(), at: [0.0; 2], heap: i > 0 }).expect("put");
        settle(&mut kitchen);
    }
    let up = kitchen.pieces()[0].up()[2];
    kitchen.apply(&Command::Flip { food: ids[0].clone() }).expect("flip");
    settle(&mut kitchen);
    println!("blocked: {:?} up {} -> {}", kitchen.blocked(), up, kitchen.pieces()[0].up()[2]);
    assert_eq!(kitchen.blocked(), [ids[0].clone()]);
    assert!(kitchen.pieces()[0].up()[2] * up > 0.0);
}

/// Nothing passes through the pan: foods thrown down at 3 m/s, and a pan jerked at its limits.
#[test]
fn nothing_tunnels_at_three_metres_a_second() {
    let (mut kitchen, ids) = kitchen(&[("shrimp", 6), ("carrot-coin", 6)]);
    put_heaped(&mut kitchen, &ids);
    kitchen.apply(&Command::Tilt { angle: 0.0, towards: 0.0 }).expect("level");
    for (at, lift) in [([0.0, 0.0], 0.46), ([0.0, 0.0], 0.0), ([0.3, 0.0], 0.2), ([-0.3, 0.0], 0.0)] {
        kitchen.apply(&Command::MovePan { at, lift }).expect("moves");
        (0..8).for_each(|_| kitchen.step());
    }
    settle(&mut kitchen);
    let pan = kitchen.world().motion.pose;
    for piece in kitchen.pieces() {
        let seen = pan.to_body(piece.pose.position);
        assert!(seen.z > 0.0 || !kitchen.world().pan_shape().holds(seen), "{} is under the floor", piece.id);
        assert!(piece.pose.position.z > 0.0, "{} is under the table", piece.id);
    }
}

/// A tilt is undone wherever the pan has been moved to since: it stands on the glass again.
#[test]
fn a_tilted_pan_that_is_moved_and_levelled_stands_on_the_glass() {
    let (mut kitchen, _) = kitchen(&[]);
    let stands = kitchen.held_pan().position.z;
    for angle in [0.5, 1.2, -0.4] {
        kitchen.apply(&Command::Tilt { angle, towards: 0.7 }).expect("tilts");
        kitchen.apply(&Command::MovePan { at: [0.1, -0.05], lift: 0.0 }).expect("moves");
        assert!(kitchen.held_pan().position.z > stands + 0.03, "its edge would be in the glass");
        kitchen.apply(&Command::Tilt { angle: 0.0, towards: 0.0 }).expect("levels");
        assert!((kitchen.held_pan().position.z - stands).abs() < 1e-12, "{angle}");
        assert!((kitchen.held_pan().position.x - 0.1).abs() < 1e-12);
    }
}

#[test]
fn bodies_sleep_most_of_the_time_while_food_shrinks_in_a_pan_at_rest() {
    let library = library();
    let mut kitchen = Kitchen::new(&library, "cast-iron-26", kelvin(200.0)).expect("a pan");
    kitchen.add(&library, &order("steak", "beef-lean", &library, 1)).expect("a piece");
    kitchen.apply(&Command::Put { food: "steak".into(), at: [0.0, 0.0], heap: false }).expect("put");
    let width = |kitchen: &Kitchen| kitchen.pieces()[0].state.stretch.lateral;
    let (first, mut asleep, ticks) = (width(&kitchen), 0, 3000);
    for _ in 0..ticks {
        kitchen.step();
        asleep += u32::from(kitchen.world().is_settled());
    }
    assert!(width(&kitchen) < 0.98 * first, "shrinks: {}", width(&kitchen));
    assert!(asleep > ticks / 2, "asleep in {asleep} of {ticks} ticks");
}

#[test]
fn a_hand_that_holds_the_pan_feels_the_weight_of_what_lies_in_it_and_more_of_it_while_it_lifts() {
    let (mut kitchen, ids) = kitchen(&[("beef-lean", 1)]);
    kitchen.apply(&Command::Put { food: ids[0].clone(), at: [0.02, 0.0], heap: false }).expect("put");
    kitchen.apply(&Command::Oil { kind: None, mass: 0.03 }).expect("oil");
    (0..20).for_each(|_| kitchen.step());
    let wrench = kitchen.pan_wrench(&FoodVelocities::of(&kitchen), FRAME_S);
    let weight = GRAVITY * (kitchen.pieces()[0].mass() + kitchen.pan_state().oil_mass());
    assert!((wrench.force.z + weight).abs() < 0.01 * weight, "{wrench:?}, {weight} N");
    // The steak lies to the right of the centre, so that the pan tends to turn down there.
    assert!(wrench.torque.y > 0.015 * GRAVITY * kitchen.pieces()[0].mass(), "{wrench:?}");

    let up = Pose { position: kitchen.held_pan().position + glam::DVec3::Z * 0.1, ..kitchen.held_pan() };
    kitchen.apply(&Command::HoldPan { pose: up }).expect("hold");
    let mut most = 0.0f64;
    for _ in 0..6 {
        let before = FoodVelocities::of(&kitchen);
        kitchen.advance_frame();
        most = most.max(-kitchen.pan_wrench(&before, FRAME_S).force.z);
    }
    assert!(most > 1.2 * weight, "{most} N of {weight} N");
}

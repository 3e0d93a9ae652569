//! Promises of the rigid bodies: rest, no sinking, no tunnelling, flips and tosses through forces alone.

use saute_kitchen::dynamics::{Pose, RIGID_S};
use saute_kitchen::{Command, Kitchen, Library, MeshSize, PieceOrder, Place, TICK_S, food::Rules, kelvin};

fn library() -> Library {
    Library::embedded().expect("embedded data")
}

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
        println!("{kind} {:?} -> {:?} up {:?} t {}", before.position, after.pose.position, after.up(), kitchen.time_s());
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

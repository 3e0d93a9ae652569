//! Promises of a turner that a person leads: it slides under food and lifts it, turns it over by its roll, presses,
//! pushes; all by bounded forces.

use glam::{DQuat, DVec3};
use saute_kitchen::dynamics::{Against, Pose, Tool};
use saute_kitchen::{Command, Kitchen, Library, MeshSize, OutlineKind, PieceOrder, food::Rules, kelvin};

fn kitchen(foods: &[(&str, [f64; 3])]) -> Kitchen {
    let library = Library::embedded().expect("embedded data");
    let mut kitchen = Kitchen::new(&library, "carbon-steel-26", kelvin(20.0)).expect("a pan");
    for (i, (kind, size)) in foods.iter().enumerate() {
        let order = PieceOrder {
            id: format!("food{i}"),
            kind: (*kind).into(),
            size: *size,
            temperature: kelvin(20.0),
            seed: i as u64 + 1,
            coarseness: 1.0,
            mesh: MeshSize::Paper2013,
            rules: Rules::Full,
            outline: OutlineKind::Plain,
        };
        kitchen.add(&library, &order).expect("a piece");
        kitchen.apply(&Command::Put { food: order.id, at: [0.0; 2], heap: i > 0 }).expect("put");
        frames(&mut kitchen, 90);
    }
    kitchen
}

fn steak() -> Kitchen {
    kitchen(&[("beef-lean", [0.12, 0.08, 0.025])])
}

/// Lets time pass; nothing may jump.
fn frames(kitchen: &mut Kitchen, count: usize) {
    for _ in 0..count {
        let before: Vec<DVec3> = kitchen.pieces().iter().map(|p| p.pose.position).collect();
        kitchen.advance_frame();
        for (piece, before) in kitchen.pieces().iter().zip(before) {
            let way = (piece.pose.position - before).length();
            assert!(way < 2.0 / 60.0, "{} jumped by {way}", piece.id);
        }
    }
}

/// The turner with its blade pointing away from the cook, rolled and pitched [rad], above the pan's floor [m].
fn held(kitchen: &Kitchen, y: f64, height: f64, [roll, pitch]: [f64; 2]) -> Pose {
    let rotation = DQuat::from_rotation_z(core::f64::consts::FRAC_PI_2)
        * DQuat::from_rotation_y(pitch)
        * DQuat::from_rotation_x(roll);
    let floor = kitchen.world().motion.pose.position.z;
    Pose { position: DVec3::new(0.0, y, floor + height), rotation }
}

fn lead(kitchen: &mut Kitchen, to: Pose, count: usize) {
    kitchen.apply(&Command::Lead { tool: Tool::Turner, to, grip: None }).expect("leads");
    frames(kitchen, count);
}

/// From the cook's side in under the middle.
fn slide_under(kitchen: &mut Kitchen) {
    let start = held(kitchen, -0.085, 0.0, [0.0; 2]);
    lead(kitchen, start, 1);
    let low = held(kitchen, -0.02, 0.0, [0.0; 2]);
    lead(kitchen, low, 30);
}

fn lifted(kitchen: &Kitchen) -> f64 {
    kitchen.pieces()[0].pose.position.z
}

fn floor_force(kitchen: &Kitchen) -> f64 {
    let contacts = kitchen.world().contacts(kitchen.pieces()[0].key);
    contacts.iter().filter(|c| c.against == Against::Floor).map(|c| c.force).sum()
}

#[test]
fn a_led_turner_slides_under_a_steak_lifts_it_off_the_pan_and_lays_it_down() {
    let mut kitchen = steak();
    let before = kitchen.pieces()[0].pose;
    slide_under(&mut kitchen);
    let slid = (kitchen.pieces()[0].pose.position - before.position).length();
    println!("moved {:.1} mm while the blade slid under it", 1e3 * slid);
    assert!(slid < 0.01, "{slid}");
    assert!(kitchen.hand().gripped().is_none());
    let up = held(&kitchen, -0.02, 0.08, [0.0; 2]);
    lead(&mut kitchen, up, 45);
    println!("lifted by {:.1} mm", 1e3 * (lifted(&kitchen) - before.position.z));
    assert!(lifted(&kitchen) > before.position.z + 0.06);
    assert!(floor_force(&kitchen) == 0.0, "it hangs free of the pan");
    let down = held(&kitchen, -0.02, 0.0, [0.0; 2]);
    lead(&mut kitchen, down, 45);
    assert!(kitchen.hand().gripped().is_none(), "laid down, it is let go");
    let out = held(&kitchen, -0.12, 0.0, [0.0; 2]);
    lead(&mut kitchen, out, 45);
    let left = (kitchen.pieces()[0].pose.position - before.position).length();
    println!("left {:.1} mm from where it lay", 1e3 * left);
    assert!(left < 0.015, "the blade comes out without it: {left}");
}

#[test]
fn a_roll_of_the_turner_turns_a_lifted_steak_over() {
    let mut kitchen = steak();
    let up = kitchen.pieces()[0].up()[2];
    slide_under(&mut kitchen);
    for (height, roll, count) in [(0.09, 0.0, 30), (0.09, 0.5, 8), (0.09, 1.6, 12), (0.09, 2.6, 12), (0.09, 3.1, 60)] {
        let to = held(&kitchen, -0.02, height, [roll, 0.0]);
        lead(&mut kitchen, to, count);
    }
    assert!(kitchen.hand().gripped().is_none(), "it fell off");
    kitchen.apply(&Command::LetGo).expect("put away");
    frames(&mut kitchen, 120);
    println!("up {up:.2} -> {:.2}", kitchen.pieces()[0].up()[2]);
    assert!(kitchen.pieces()[0].up()[2] * up < -0.8);
    assert!(kitchen.pieces()[0].in_pan() && !kitchen.hand().is_active());
    assert!(kitchen.pieces()[0].flipped_at().is_some(), "it was turned over");
}

#[test]
fn a_steak_that_is_turned_slowly_counts_as_turned_also_with_an_edge_on_the_pan() {
    for (height, frames_of_step) in [(0.02, 16), (0.04, 30), (0.06, 30)] {
        let mut kitchen = steak();
        let up = kitchen.pieces()[0].up()[2];
        slide_under(&mut kitchen);
        for step in 1..=16u8 {
            let to = held(&kitchen, -0.02, height, [0.2 * f64::from(step), 0.0]);
            lead(&mut kitchen, to, frames_of_step);
        }
        kitchen.apply(&Command::LetGo).expect("put away");
        frames(&mut kitchen, 120);
        let piece = &kitchen.pieces()[0];
        println!("{height} m: up {up:.2} -> {:.2}, turned at {:?}", piece.up()[2], piece.flipped_at());
        assert!(piece.up()[2] * up < -0.8 && piece.flipped_at().is_some(), "{height} m: {:?}", piece.up());
    }
}

#[test]
fn a_turner_lowered_onto_a_steak_presses_it_with_a_bounded_force() {
    let mut kitchen = steak();
    let resting = floor_force(&kitchen);
    let above = held(&kitchen, 0.0, 0.06, [0.0; 2]);
    lead(&mut kitchen, above, 10);
    let mut forces = Vec::new();
    for height in [0.02, 0.01, 0.0] {
        let to = held(&kitchen, 0.0, height, [0.0; 2]);
        lead(&mut kitchen, to, 60);
        forces.push(floor_force(&kitchen) - resting);
    }
    println!("resting {resting:.2} N, pressed {forces:.2?} N");
    assert!(forces[0] > 1.0 && forces[1] > forces[0] + 1.0 && forces[2] > forces[1] + 1.0, "{forces:?}");
    assert!(forces[2] < 14.0, "a hand yields: {forces:?}");
    let pressed = kitchen.pieces()[0].pan_force();
    assert!(pressed > resting + 3.0, "the contact feels it: {pressed}");
    lead(&mut kitchen, above, 60);
    assert!((floor_force(&kitchen) - resting).abs() < 0.5 * resting, "{}", floor_force(&kitchen));
}

#[test]
fn an_upright_turner_pushes_a_steak_sideways() {
    let mut kitchen = steak();
    let before = kitchen.pieces()[0].pose.position;
    for (y, height, count) in [(-0.075, 0.08, 5), (-0.075, 0.047, 15), (-0.01, 0.047, 60)] {
        let to = held(&kitchen, y, height, [0.0, core::f64::consts::FRAC_PI_2]);
        lead(&mut kitchen, to, count);
    }
    let way = kitchen.pieces()[0].pose.position - before;
    println!("pushed by {way}");
    assert!(way.y > 0.015 && way.z.abs() < 0.01, "{way}");
    assert!(kitchen.hand().gripped().is_none());
}

#[test]
fn what_is_held_down_is_not_lifted() {
    let heavy = [0.15, 0.11, 0.04];
    let mut kitchen =
        kitchen(&[("beef-patty", [0.1, 0.1, 0.02]), ("beef-lean", heavy), ("beef-lean", heavy), ("beef-lean", heavy)]);
    let before = lifted(&kitchen);
    slide_under(&mut kitchen);
    let up = held(&kitchen, -0.02, 0.10, [0.0; 2]);
    let mut highest = 0.0f64;
    for _ in 0..90 {
        lead(&mut kitchen, up, 1);
        highest = highest.max(lifted(&kitchen) - before);
    }
    println!("lifted by {:.1} mm at most", 1e3 * highest);
    assert!(highest < 0.03, "{highest}");
}

#[test]
fn a_task_takes_the_place_of_a_led_turner() {
    let mut kitchen = steak();
    slide_under(&mut kitchen);
    let up = kitchen.pieces()[0].up()[2];
    kitchen.apply(&Command::Flip { food: "food0".into() }).expect("flips");
    frames(&mut kitchen, 240);
    assert!(!kitchen.busy());
    assert!(kitchen.pieces()[0].up()[2] * up < -0.8);
}

//! Promise: food that a tool in the hand turns over counts as flipped in results, rows of studies and the guide of a plan, as food that
//! was flipped by a command does; and not twice.

use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use glam::{DQuat, DVec3};
use saute_controls::act::{Act, CookAct, Setting};
use saute_controls::goal_choice::goal_of;
use saute_kitchen::Command;
use saute_kitchen::dynamics::{Pose, Tool};
use saute_session::FoodChoice;
use saute_study::Times;
use saute_window::SauteApp;

use super::{WIDE, act, set};
use crate::harness::{cook, press, steps, window};

/// The turner with its blade pointing away from the cook, rolled [rad], at a place above the pan's floor [m].
fn held(harness: &Harness<'static, SauteApp>, [y, height]: [f64; 2], roll: f64) -> Pose {
    let rotation = DQuat::from_rotation_z(core::f64::consts::FRAC_PI_2) * DQuat::from_rotation_x(roll);
    let floor = harness.state().session().kitchen.world().motion.pose.position.z;
    Pose { position: DVec3::new(0.0, y, floor + height), rotation }
}

fn lead(harness: &mut Harness<'static, SauteApp>, at: [f64; 2], roll: f64, ticks: usize) {
    let to = held(harness, at, roll);
    let session = harness.state_mut().session_mut();
    session.command(&Command::Lead { tool: Tool::Turner, to, grip: None }).expect("leads");
    (0..ticks).for_each(|_| session.tick().map(drop).expect("ticks"));
}

/// Turns the steak in the middle of the pan over as a hand does: in under it, up, round, and away.
pub fn turn_by_hand(harness: &mut Harness<'static, SauteApp>) {
    lead(harness, [-0.085, 0.0], 0.0, 1);
    lead(harness, [-0.02, 0.0], 0.0, 5);
    (0..=16u8).for_each(|step| lead(harness, [-0.02, 0.08], 0.2 * f64::from(step), 5));
    harness.state_mut().session_mut().command(&Command::LetGo).expect("lets go");
    cook(harness, 2.0);
}

/// A steak in the pan.
fn frying() -> Harness<'static, SauteApp> {
    let mut harness = window(WIDE);
    let choice = FoodChoice { size_mm: vec![60.0, 50.0, 15.0], ..FoodChoice::default() };
    set(&mut harness, Setting::Choice(choice));
    act(&mut harness, Act::Cook(CookAct::SetOut(1)));
    press(&mut harness, egui::Key::A);
    cook(&mut harness, 2.0);
    harness
}

/// Flips by the result and by a row of a study.
fn counted(harness: &Harness<'static, SauteApp>) -> [f64; 2] {
    let app = harness.state();
    let goal = goal_of(app.session(), app.settings()).expect("a goal");
    let terms = app.session().judgement(&goal).expect("there is food").terms;
    let flips = terms.iter().find(|term| term.kind == saute_plan::goal::TermKind::Flips).expect("a term").value;
    [flips, f64::from(Times::of(app.session().recording(), &app.session().recorder).flips)]
}

#[test]
fn a_steak_turned_by_the_turner_in_the_hand_counts_as_flipped_and_not_before() {
    let mut harness = frying();
    let down = harness.state().session().kitchen.pieces()[0].upside_down();
    assert_eq!(counted(&harness), [0.0; 2]);
    turn_by_hand(&mut harness);
    assert_ne!(harness.state().session().kitchen.pieces()[0].upside_down(), down, "the turner turns it over");
    assert_eq!(counted(&harness), [1.0; 2]);
    // A command counts once more, though it is carried out by the same turner.
    press(&mut harness, egui::Key::F);
    cook(&mut harness, 4.0);
    assert_eq!(counted(&harness), [2.0; 2]);
    // Out and in again is no flip, whatever face is below then.
    press(&mut harness, egui::Key::O);
    cook(&mut harness, 4.0);
    press(&mut harness, egui::Key::A);
    cook(&mut harness, 4.0);
    assert!(harness.state().session().kitchen.pieces()[0].in_pan());
    assert_eq!(counted(&harness), [2.0; 2]);
    // Back to before all of it: nothing was turned.
    harness.state_mut().session_mut().scrub(1.0);
    steps(&mut harness, 30);
    assert_eq!(counted(&harness), [0.0; 2]);
    assert!(harness.query_by_label("Flip").is_some());
}

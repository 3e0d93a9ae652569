//! Promise: while a plan is followed there is one voice: its guide gives the orders, its scale and goal are the panel's, time comes back
//! to its speed, and the result measures the cook by what the plan promised.

use egui::{Key, Modifiers};
use egui_kittest::{Harness, kittest::Queryable};
use saute_controls::act::{Act, AppAct, CookAct, Setting, TimeAct};
use saute_kitchen::Library;
use saute_kitchen::advice::Advice;
use saute_plan::goal::mark::Mark;
use saute_plan::schedule::Plan;
use saute_window::SauteApp;

use super::plan::{PHONE, WIDE, act, due, found, plan, plan_for};
use crate::harness::{WINDOW, save, steps};

/// Beginnings of orders that advice, coach and alarm give.
const ORDERS: [&str; 5] = ["Take it out now", "Flip the", "turn the hob", "Turn the hob", "The pan is hot. Put"];

fn says(harness: &Harness<'static, SauteApp>, words: &str) -> bool {
    harness.query_all_by_label_contains(words).next().is_some()
}

fn time_s(harness: &Harness<'static, SauteApp>) -> f64 {
    harness.state().session().kitchen.time_s()
}

/// The cook of the small steak's plan, at its beginning.
fn live(size: egui::Vec2) -> (Harness<'static, SauteApp>, Plan) {
    let plan = plan(&Library::embedded().expect("embedded data"));
    (live_by(size, plan.clone()), plan)
}

fn live_by(size: egui::Vec2, plan: Plan) -> Harness<'static, SauteApp> {
    let mut harness = found(size, plan);
    harness.get_by_label("Cook it live").click();
    steps(&mut harness, 3);
    harness
}

/// Lets time pass up to a time [s]; steps that are due are done by the button. `look` is called every second and before each step.
fn go_to(
    harness: &mut Harness<'static, SauteApp>,
    until_s: f64,
    look: &mut dyn FnMut(&mut Harness<'static, SauteApp>),
) {
    while time_s(harness) < until_s - 1e-6 {
        if due(harness) {
            steps(harness, 2);
            look(harness);
            if let Some(button) = harness.query_by_label_contains("Do it: ") {
                button.click();
            }
            steps(harness, 2);
        }
        for _ in 0..10 {
            harness.state_mut().session_mut().tick().expect("ticks");
            if due(harness) || time_s(harness) >= until_s {
                break;
            }
        }
        harness.step();
        look(harness);
    }
}

fn go(harness: &mut Harness<'static, SauteApp>, until_s: f64) {
    go_to(harness, until_s, &mut |_| {});
}

/// Lets time pass, and nobody does anything.
fn wait(harness: &mut Harness<'static, SauteApp>, until_s: f64) {
    while time_s(harness) < until_s - 1e-6 {
        harness.state_mut().session_mut().tick().expect("ticks");
    }
    steps(harness, 3);
}

#[test]
fn a_plan_that_is_kept_to_is_contradicted_by_nobody() {
    let (mut harness, _) = live(WIDE);
    let mut orders = 0;
    go_to(&mut harness, 259.0, &mut |harness| {
        for order in ORDERS {
            assert!(!says(harness, order), "{order} at {:.1} s", time_s(harness));
        }
        let goal = harness.state().scale().map(|scale| (scale.clone(), harness.state().settings().goal(&scale)));
        let advice = harness.state_mut().session_mut().advice(goal);
        orders += usize::from(advice.iter().any(|one| one.is_due()));
    });
    assert!(orders > 10, "the advice alone gives orders: {orders}");
    assert!(says(&harness, "The plan says what to do"));
}

#[test]
fn who_leaves_the_plan_is_told_so_and_advised_again() {
    let (mut harness, _) = live(WIDE);
    go(&mut harness, 104.0);
    wait(&mut harness, 119.0);
    assert!(!says(&harness, "Plan left") && says(&harness, "The plan says what to do"));
    wait(&mut harness, 140.0);
    assert!(says(&harness, "Plan left: “flip 1” is missing"));
    save(&mut harness, "plan-left");
    wait(&mut harness, 300.0);
    assert!(ORDERS.iter().any(|order| says(&harness, order)), "the advice speaks again");
    let (mut harness, _) = live(WIDE);
    go(&mut harness, 95.0);
    act(&mut harness, Act::Cook(CookAct::HobSet(1500.0)));
    wait(&mut harness, 103.0);
    assert!(!says(&harness, "Plan left"));
    harness.get_by_label_contains("The plan says what to do");
    go(&mut harness, 111.5);
    assert!(says(&harness, "Plan left: it wants 400 W"));
    let is_led = |harness: &Harness<'static, SauteApp>| says(harness, "The plan says what to do");
    assert!(!is_led(&harness));
    act(&mut harness, Act::Cook(CookAct::HobSet(400.0)));
    assert!(is_led(&harness) && !says(&harness, "Plan left"), "the guide has the word again");
}

#[test]
fn oil_near_its_flash_point_is_warned_of_whatever_the_plan_says() {
    use saute_plan::schedule::voice::Keeping;
    let hot = Advice::TooHot { hottest_c: 300.0, smokes: true, to_w: 500.0 };
    assert_eq!(Keeping::Kept.leaves(&[hot]), [hot]);
}

#[test]
fn the_scale_and_the_goal_of_the_plan_are_those_of_the_panel() {
    let plan = plan(&Library::embedded().expect("embedded data"));
    let mut harness = found(WIDE, plan);
    act(&mut harness, Act::App(AppAct::Set(Setting::Scale("paper-2013".into()))));
    act(&mut harness, Act::App(AppAct::Set(Setting::Goal(75.0))));
    harness.get_by_label("Cook it live").click();
    steps(&mut harness, 3);
    let app = harness.state();
    let scale = app.scale().expect("a scale");
    assert_eq!(scale.id, "chefs");
    assert_eq!(scale.name_of(scale.of_nodes(app.settings().goal(&scale))), "medium");
    // The panels name it; a notice about it would hide the one that another cook begins.
    assert!(!app.said().iter().any(|said| said.contains("Scale of doneness: Chefs")), "{:?}", app.said());
}

#[test]
fn the_end_is_done_when_the_food_is_out_and_the_hob_is_off() {
    let (mut harness, _) = live(PHONE);
    go(&mut harness, 199.8);
    wait(&mut harness, 200.0);
    harness.get_by_label("Do it: out of the pan, hob off");
    act(&mut harness, Act::Cook(CookAct::Out));
    wait(&mut harness, 204.0);
    assert!(harness.state().session().kitchen.hob_w() > 0.0);
    harness.get_by_label_contains("Hob off, ");
    // A button that has just become another one takes no click.
    steps(&mut harness, 26);
    save(&mut harness, "plan-live-hob-left-phone");
    harness.get_by_label("Do it: hob off").click();
    steps(&mut harness, 3);
    assert_eq!(harness.state().session().kitchen.hob_w(), 0.0);
    harness.get_by_label_contains("Rested: serve");
}

#[test]
fn time_slows_down_for_a_step_which_the_guide_says_and_comes_back_to_its_speed() {
    let (mut harness, _) = live(WIDE);
    assert!(says(&harness, "Step 1 of"), "steps count from 1");
    assert!(!says(&harness, "Start the clock"), "doing the step that is due starts it");
    go(&mut harness, 30.0);
    act(&mut harness, Act::Time(TimeAct::SpeedSet(20.0)));
    wait(&mut harness, 41.0);
    assert_eq!(harness.state().session().speed, 1.0);
    assert!(says(&harness, "At 1× for this step; after it at 20× again."));
    save(&mut harness, "plan-live-slowed");
    go(&mut harness, 48.0);
    assert_eq!(harness.state().session().speed, 20.0);
    go(&mut harness, 86.0);
    assert_eq!(harness.state().session().speed, 1.0);
    act(&mut harness, Act::Time(TimeAct::SpeedSet(1.0)));
    go(&mut harness, 92.0);
    assert_eq!(harness.state().session().speed, 1.0, "who chooses a speed keeps it");
}

#[test]
fn a_step_can_be_done_by_the_button_once_it_is_due_and_the_eye_follows_what_comes_out() {
    let (mut harness, _) = live(WIDE);
    go(&mut harness, 100.0);
    let is_there = |harness: &Harness<'static, SauteApp>| harness.query_by_label("Do it: flip 1").is_some();
    assert!(!is_there(&harness), "5 s before");
    wait(&mut harness, 105.0);
    assert!(is_there(&harness));
    go(&mut harness, 199.8);
    wait(&mut harness, 200.0);
    let pan_before = harness.state().on_screen(glam::Vec3::ZERO, WINDOW).expect("in view");
    harness.get_by_label("Do it: out of the pan, hob off").click();
    steps(&mut harness, 2);
    wait(&mut harness, 206.0);
    steps(&mut harness, 30);
    let pan = harness.state().on_screen(glam::Vec3::ZERO, WINDOW);
    assert!(
        pan.is_none_or(|pan| (pan - pan_before).length() > 40.0),
        "the eye turns to the board: {pan:?} {pan_before:?}"
    );
}

#[test]
fn a_plan_that_was_followed_opens_its_result_as_planned_and_cooking_again_can_be_undone() {
    let plan = plan_for(&Library::embedded().expect("embedded data"), "core=46", 0.0);
    assert!(plan.shortfalls().is_empty(), "{:?}", plan.shortfalls());
    let mut harness = live_by(WIDE, plan.clone());
    go(&mut harness, 263.0);
    steps(&mut harness, 4);
    harness.get_by_label_contains("One thing to do better");
    save(&mut harness, "plan-result");
    harness.get_by_label_contains("Goal met as planned: a core of 46");
    let promised = Mark::of(&plan.promised, &plan.order.goal).points();
    assert!(says(&harness, &format!("The plan, the best that was found, promised {promised:.0}.")));
    harness.get_by_label("Nothing: it came out as the plan promised.");
    assert!(!says(&harness, "less power") && !says(&harness, "Flip more often"));
    harness.get_by_label("Done").click();
    steps(&mut harness, 3);
    harness.get_by_label("End the guide").click();
    steps(&mut harness, 3);
    assert!(!says(&harness, "Rested: serve"));
    harness.get_by_label("Result").click();
    steps(&mut harness, 3);
    harness.get_by_label_contains("Goal met as planned");
    let before_s = time_s(&harness);
    harness.get_by_label("Cook again").click();
    steps(&mut harness, 3);
    assert!(time_s(&harness) < 2.0);
    harness.get_by_label_contains("A new cook begins. Undo (Ctrl+Z)");
    harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    steps(&mut harness, 30);
    assert!((time_s(&harness) - before_s).abs() < 5.0, "{} s", time_s(&harness));
}

#[test]
fn a_step_that_came_late_is_what_to_do_better_and_the_same_plan_again_opens_its_result_again() {
    let (mut harness, _) = live(WIDE);
    go(&mut harness, 199.8);
    wait(&mut harness, 250.0);
    harness.get_by_label("Do it: out of the pan, hob off").click();
    steps(&mut harness, 2);
    wait(&mut harness, 262.0);
    steps(&mut harness, 4);
    harness.get_by_label_contains("Keep to the plan: “out of the pan, hob off” came 50 s late.");
    save(&mut harness, "plan-result-late");
    for _ in 0..2 {
        harness.get_by_label("Cook again").click();
        steps(&mut harness, 3);
        go(&mut harness, 263.0);
        steps(&mut harness, 4);
        harness.get_by_label_contains("One thing to do better");
    }
    harness.state_mut().set_language(crate::harness::japanese());
    steps(&mut harness, 4);
    save(&mut harness, "plan-result-japanese");
}

/// What the plan itself does is not scolded either.
#[test]
fn a_plan_that_misses_its_goal_is_as_planned_too_and_one_that_cooks_itself_is_judged_by_its_promise() {
    let plan = plan(&Library::embedded().expect("embedded data"));
    let mut harness = found(WIDE, plan);
    harness.get_by_label("Let it cook itself").click();
    steps(&mut harness, 3);
    wait(&mut harness, 259.0);
    harness.get_by_label("Result").click();
    steps(&mut harness, 4);
    harness.get_by_label("Goal missed: medium");
    harness.get_by_label_contains("It came out as planned. No plan that was found meets this goal");
    assert!(!says(&harness, "Leave it in"));
}

//! The tutorial: whoever follows its instructions gets a steak, in less than three minutes of their time.

use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use saute_controls::act::{Act, LearnAct};
use saute_controls::tutorial::{FAST, MOST_S, Step};
use saute_kitchen::doneness::core_class;
use saute_window::SauteApp;
use saute_window::ui::layout::Layout;

use super::{PHONE, WIDE, act, says};
use crate::harness::{save, steps, window};

/// Presses the button that the line means, where it means one now.
fn follow(harness: &mut Harness<'static, SauteApp>, step: Step) {
    let meant = match step {
        _ if says(harness, "First the hob.") => {
            harness.query_all_by_label_contains("As advised: hob to ").next().expect("a button does it").click();
            None
        }
        Step::HobOn => Some("1100 W"),
        Step::PutIn => Some("In the pan"),
        Step::Inside => Some("Cut"),
        Step::Flip => says(harness, "Flip it now: click").then_some("Flip"),
        Step::TakeOut if says(harness, "once more") => Some("Flip"),
        Step::TakeOut => says(harness, "click “Take out”").then_some("Take out"),
        Step::HobOff => Some("off"),
        Step::Halve => Some("Halve"),
        Step::Result => Some("Result"),
        Step::Heat | Step::Rest => None,
    };
    let Some(button) = meant else { return };
    harness.get_by_label(button).click();
    steps(harness, 3);
}

/// Follows the tutorial to its end; returns how long that takes [s], reading included, and the pictures' names.
fn followed(harness: &mut Harness<'static, SauteApp>, name: &str) -> f64 {
    act(harness, Act::Learn(LearnAct::Tutorial(true)));
    // Frames of a slow machine let no time pass: ticks do.
    harness.state_mut().session_mut().set_paused(true);
    steps(harness, 12);
    let (mut reading_s, mut passed, mut last) = (0.0, [0.0; 2], None);
    while let Some(tutorial) = harness.state().tutorial().cloned() {
        passed = tutorial.passed_s();
        let step = tutorial.step();
        if last != Some(step) {
            (reading_s, last) = (reading_s + step.reading_s(), Some(step));
            steps(harness, 10);
            save(harness, &format!("tutorial-{name}-{step:?}"));
        }
        // What was requested takes effect in time, as smoke that stops; a person does not click twice in two seconds.
        follow(harness, step);
        (0..20).for_each(|_| harness.state_mut().session_mut().tick().expect("ticks"));
        steps(harness, 1);
        while harness.state().session().kitchen.busy() {
            harness.state_mut().session_mut().tick().expect("ticks");
        }
        assert!(harness.state().session().kitchen.time_s() < 3600.0, "the tutorial leads nowhere: {step:?}");
    }
    println!("{name}: {:.0} s cooked in {:.0} s, and {reading_s:.0} s of reading", passed[0], passed[1]);
    passed[1] + reading_s
}

#[test]
fn the_tutorial_takes_less_than_three_minutes_and_ends_with_a_steak_and_its_result() {
    let mut harness = window(WIDE);
    let took_s = followed(&mut harness, "wide");
    assert!(took_s < MOST_S, "{took_s} s");
    let app = harness.state();
    let (steak, scale) = (app.session().shown_piece().expect("steak"), app.scale().expect("a scale"));
    assert_eq!(core_class(steak, &scale), "medium");
    assert!(steak.halved().is_some() && says(&harness, "One thing to do better"));
    assert!(says(&harness, "Goal met: Medium, with a crust"), "whoever follows is not told that it went wrong");
    steps(&mut harness, 3);
    save(&mut harness, "tutorial-wide-end");
}

#[test]
fn the_tutorial_can_be_left_covers_no_pan_and_runs_fast_only_while_one_waits() {
    for size in [WIDE, PHONE] {
        let mut harness = window(size);
        let usual = harness.state().session().speed;
        act(&mut harness, Act::Learn(LearnAct::Tutorial(true)));
        harness.state_mut().session_mut().set_paused(true);
        steps(&mut harness, 12);
        save(&mut harness, if size == WIDE { "tutorial-begin" } else { "tutorial-begin-phone" });
        let line = harness.get_by_label_contains("Turn the hob on. Click").rect();
        let whole = egui::Rect::from_min_size(egui::Pos2::ZERO, size);
        // The pan is in the middle of what no panel covers.
        let pan = Layout::new(whole, harness.state().settings()).free.center();
        assert!(line.top() - pan.y > 120.0, "{line:?} {pan:?}");
        assert_eq!(harness.state().session().speed, 1.0);
        harness.get_by_label("1100 W").click();
        steps(&mut harness, 4);
        assert_eq!(harness.state().session().speed, FAST, "the pan heats");
        harness.get_by_label("Skip").click();
        steps(&mut harness, 3);
        assert!(harness.state().tutorial().is_none() && harness.state().session().speed == usual);
    }
}

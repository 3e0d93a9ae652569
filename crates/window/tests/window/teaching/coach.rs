//! The coach: what happens and why, the next cue, an alarm at the goal; all of it can be off.

use egui_kittest::kittest::Queryable;
use saute_controls::act::Setting;
use saute_kitchen::{Command, Place, celsius};

use super::{PHONE, WIDE, command, core_c, put_in, says, set, small_steak, until};
use crate::harness::{save, steps};

#[test]
fn the_coach_says_what_happens_and_what_to_perceive_next_and_can_be_off() {
    let mut harness = small_steak(WIDE);
    assert!(says(&harness, "A cold pan would stew the food"));
    let fits = harness.get_by_label("Core").rect();
    put_in(&mut harness);
    until(&mut harness, |session| session.shown_piece().is_some_and(|steak| celsius(steak.face(true)) > 95.0));
    steps(&mut harness, 12);
    assert!(says(&harness, "Next to hear: the sizzle fades") && says(&harness, "Water boils off below"));
    assert_eq!(harness.get_by_label("Core").rect(), fits, "nothing jumps");
    save(&mut harness, "coach-wet");
    set(&mut harness, Setting::Coach(false));
    assert!(!says(&harness, "Next to hear: ") && !says(&harness, "Water boils off"));
    assert_eq!(harness.get_by_label("Core").rect(), fits);
}

#[test]
fn the_line_at_the_goal_takes_the_food_out_by_one_click_and_is_gone_then() {
    for size in [WIDE, PHONE] {
        let mut harness = small_steak(size);
        put_in(&mut harness);
        until(&mut harness, |session| core_c(session) > 30.0);
        command(&mut harness, &Command::Flip { food: "steak".into() });
        steps(&mut harness, 3);
        assert!(!says(&harness, "Take it out now") && !harness.state().pad_pulses());
        until(&mut harness, |session| core_c(session) > 60.0);
        steps(&mut harness, 1);
        assert!(harness.state().pad_pulses(), "a gamepad says it, too");
        steps(&mut harness, 12);
        assert!(!harness.state().pad_pulses(), "once");
        assert!(says(&harness, "Take it out now"));
        save(&mut harness, if size == WIDE { "coach-alarm" } else { "coach-alarm-phone" });
        harness.get_by_label("Take it out: the goal is reached").click();
        harness.state_mut().session_mut().set_paused(false);
        steps(&mut harness, 3);
        let out = |session: &saute_controls::session::Session| {
            session.shown_piece().is_some_and(|steak| matches!(steak.place, Place::Rest(_)))
        };
        until(&mut harness, out);
        steps(&mut harness, 3);
        assert!(!says(&harness, "Take it out now"));
    }
}

#[test]
fn without_the_coach_no_gamepad_pulses_at_the_goal() {
    let mut harness = small_steak(WIDE);
    set(&mut harness, Setting::Coach(false));
    put_in(&mut harness);
    until(&mut harness, |session| core_c(session) > 30.0);
    command(&mut harness, &Command::Flip { food: "steak".into() });
    until(&mut harness, |session| core_c(session) > 60.0);
    steps(&mut harness, 1);
    assert!(!harness.state().pad_pulses());
    set(&mut harness, Setting::Coach(true));
    assert!(harness.state().pad_pulses(), "switched on, it says so");
}

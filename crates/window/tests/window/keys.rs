//! Promise: keys do what their descriptions state and nothing else; time is stopped where nobody can cook; nothing that was chosen is lost.

use egui::{Event, Key, Modifiers, vec2};
use egui_kittest::{Harness, kittest::Queryable};
use saute_window::SauteApp;

use crate::harness::{cook, press, save, steps, window};
use crate::steak::Memory;

fn hob(harness: &Harness<'static, SauteApp>) -> f64 {
    harness.state().session().kitchen.hob_w()
}

#[test]
fn a_letter_with_control_does_nothing_even_if_control_is_up_again_at_once() {
    let mut harness = window(vec2(1280.0, 720.0));
    for modifiers in [Modifiers::CTRL, Modifiers::COMMAND, Modifiers::ALT, Modifiers::CTRL | Modifiers::SHIFT] {
        for key in [Key::E, Key::A, Key::R, Key::C, Key::W] {
            harness.event(Event::Key { key, physical_key: None, pressed: true, repeat: false, modifiers });
            harness.event(Event::ModifiersChanged(Modifiers::NONE));
            steps(&mut harness, 2);
        }
    }
    let app = harness.state();
    assert!(hob(&harness) == 0.0 && app.session().kitchen.cloth().is_none() && !app.settings().fahrenheit);
    assert!(!app.session().shown_piece().expect("steak").in_pan());
}

#[test]
fn tab_shows_where_the_focus_is_and_silences_no_key() {
    let mut harness = window(vec2(1280.0, 720.0));
    let before = harness.render().expect("renders");
    while !harness.get_by_label("Flip").is_focused() && !harness.get_by_label("Temperature").is_focused() {
        press(&mut harness, Key::Tab);
    }
    steps(&mut harness, 14);
    let rect = harness.get_by_label("Temperature").rect();
    let after = harness.render().expect("renders");
    save(&mut harness, "focus");
    let (x, y) = (rect.center().x as u32, (rect.top() + 1.0) as u32);
    let change = (0..3).map(|k| before.get_pixel(x, y)[k].abs_diff(after.get_pixel(x, y)[k])).max();
    assert!(change > Some(90), "the edge of what has the focus stands out: {change:?}");
    press(&mut harness, Key::E);
    assert_eq!(hob(&harness), 400.0, "letters still work");
    press(&mut harness, Key::Space);
    assert!(!harness.state().session().paused, "Space presses what has the focus");
}

#[test]
fn time_waits_behind_every_card_and_nobody_cooks_there() {
    let mut harness = window(vec2(1280.0, 720.0));
    press(&mut harness, Key::E);
    for key in [Key::F1, Key::F2, Key::F3] {
        press(&mut harness, key);
        let time = harness.state().session().kitchen.time_s();
        steps(&mut harness, 10);
        press(&mut harness, Key::E);
        assert_eq!(harness.state().session().kitchen.time_s(), time, "{key:?}");
        assert_eq!(hob(&harness), 400.0);
        press(&mut harness, Key::Escape);
        steps(&mut harness, 10);
        assert!(harness.state().session().kitchen.time_s() > time, "{key:?}: it goes on");
        assert!(!harness.state().session().paused && harness.state().session().behind_s().is_none());
    }
}

#[test]
fn what_a_hand_does_while_time_stands_still_says_when_it_happens() {
    let mut harness = window(vec2(1280.0, 720.0));
    press(&mut harness, Key::A);
    cook(&mut harness, 1.0);
    press(&mut harness, Key::Space);
    press(&mut harness, Key::F);
    harness.get_by_label_contains("it happens when time goes on");
    press(&mut harness, Key::Space);
    cook(&mut harness, 3.0);
    assert!(harness.state().session().shown_piece().expect("steak").upside_down());
}

#[test]
fn a_chosen_food_is_still_chosen_after_the_settings_were_saved() {
    let mut harness = window(vec2(1280.0, 720.0));
    press(&mut harness, Key::N);
    harness.get_by_label("Shrimp").click();
    steps(&mut harness, 2);
    let mut memory = Memory::default();
    eframe::App::save(harness.state_mut(), &mut memory);
    steps(&mut harness, 2);
    assert_eq!(harness.state().settings().choice.kind, "shrimp");
    let stored = memory.0.into_values().next();
    let again = SauteApp::start(&egui::Context::default(), None, stored, Default::default()).expect("starts");
    assert_eq!(again.settings().choice.kind, "shrimp");
    assert!(eframe::App::auto_save_interval(&again).as_secs() < 10, "who is cut off loses little");
}

#[test]
fn a_speed_that_the_machine_cannot_hold_drops_and_says_so_once() {
    let mut harness = window(vec2(1280.0, 720.0));
    press(&mut harness, Key::N);
    harness.get_by_label("Shrimp").click();
    steps(&mut harness, 2);
    harness.state_mut().set_count(35);
    steps(&mut harness, 2);
    harness.get_by_label("Add 35").click();
    steps(&mut harness, 3);
    harness.get_by_label("In a heap").click();
    harness.state_mut().session_mut().command(&saute_kitchen::Command::Hob(1100.0)).expect("hob");
    harness.get_by_label("20×").click();
    for _ in 0..120 {
        steps(&mut harness, 1);
        if harness.state().session().speed < 20.0 {
            break;
        }
    }
    assert!(harness.state().session().speed < 20.0);
    harness.get_by_label_contains("This machine cannot hold 20×");
    assert_eq!(harness.state().settings().speed, 20.0, "the wish is kept");
    save(&mut harness, "slowed");
}

//! Promise: the window is usable: everything can be done by its controls and keys, and it looks as it should.

use egui::{Key, Pos2, pos2, vec2};
use egui_kittest::{
    Harness,
    kittest::{NodeT, Queryable},
};
use saute_kitchen::{Command, Place};
use saute_picture::View;
use saute_window::{SauteApp, Start};

use crate::harness::{WINDOW, click, cook, drag, press, save, steps, window};

#[test]
fn a_first_cook_by_buttons_alone() {
    let mut harness = window(vec2(1280.0, 720.0));
    save(&mut harness, "start");
    harness.get_by_label("1100 W").click();
    steps(&mut harness, 2);
    assert_eq!(harness.state().session().kitchen.hob_w(), 1100.0);
    cook(&mut harness, 100.0);
    harness.get_by_label("In the pan").click();
    steps(&mut harness, 14);
    assert!(matches!(harness.state().session().shown_piece().expect("steak").place, Place::Pan(_)));
    cook(&mut harness, 60.0);
    save(&mut harness, "one-minute");
    cook(&mut harness, 180.0);
    harness.get_by_label("Flip").click();
    for moment in ["under", "lifted", "over"] {
        steps(&mut harness, 8);
        save(&mut harness, &format!("flip-{moment}"));
    }
    cook(&mut harness, 2.0);
    assert!(harness.state().session().shown_piece().expect("steak").upside_down());
    save(&mut harness, "flipped");
    harness.get_by_label("Cut").click();
    cook(&mut harness, 120.0);
    save(&mut harness, "cut");
    harness.get_by_label("Temperature").click();
    steps(&mut harness, 12);
    assert_eq!(harness.state().settings().view, View::Temperature);
    save(&mut harness, "temperature");
    harness.get_by_label("Doneness").click();
    steps(&mut harness, 12);
    save(&mut harness, "doneness");
    harness.get_by_label("Look").click();
    harness.get_by_label("Take out").click();
    steps(&mut harness, 14);
    save(&mut harness, "tongs");
    cook(&mut harness, 2.0);
    assert!(matches!(harness.state().session().shown_piece().expect("steak").place, Place::Rest(_)));
    save(&mut harness, "resting");
}

#[test]
fn every_operation_has_a_key() {
    let mut harness = window(vec2(1280.0, 720.0));
    let press = |h: &mut Harness<'static, SauteApp>, key| {
        h.key_press(key);
        steps(h, 2);
    };
    press(&mut harness, Key::E);
    assert_eq!(harness.state().session().kitchen.hob_w(), 400.0);
    press(&mut harness, Key::Q);
    assert_eq!(harness.state().session().kitchen.hob_w(), 0.0);
    press(&mut harness, Key::A);
    assert!(harness.state().session().shown_piece().expect("steak").in_pan());
    let before = harness.state().session().shown_piece().expect("steak").upside_down();
    press(&mut harness, Key::F);
    cook(&mut harness, 2.0);
    assert_ne!(harness.state().session().shown_piece().expect("steak").upside_down(), before);
    press(&mut harness, Key::O);
    cook(&mut harness, 2.0);
    assert!(!harness.state().session().shown_piece().expect("steak").in_pan());
    press(&mut harness, Key::W);
    assert!(harness.state().session().kitchen.cloth().is_some());
    press(&mut harness, Key::Space);
    assert!(harness.state().session().paused);
    let tick = harness.state().session().kitchen.tick();
    press(&mut harness, Key::Period);
    assert_eq!(harness.state().session().kitchen.tick(), tick + 1);
    press(&mut harness, Key::CloseBracket);
    assert_eq!(harness.state().session().speed, 2.0);
    press(&mut harness, Key::OpenBracket);
    assert_eq!(harness.state().session().speed, 1.0);
    press(&mut harness, Key::Num2);
    assert_eq!(harness.state().settings().view, View::Temperature);
    press(&mut harness, Key::Num4);
    assert_eq!(harness.state().settings().view, View::Doneness);
    press(&mut harness, Key::Num1);
    assert_eq!(harness.state().settings().view, View::Look);
    press(&mut harness, Key::X);
    assert_eq!(harness.state().slice(), Some(0.0));
    press(&mut harness, Key::L);
    assert!(harness.state().slice().expect("cut") > 0.0);
    press(&mut harness, Key::C);
    assert!(harness.state().settings().fahrenheit);
    press(&mut harness, Key::R);
    assert_eq!(harness.state().session().shown_piece().expect("steak").place, Place::Waiting);
    press(&mut harness, Key::F1);
    assert!(harness.state().help_is_open());
    save(&mut harness, "help");
    press(&mut harness, Key::Escape);
    assert!(!harness.state().help_is_open());
}

#[test]
fn the_steak_is_chosen_before_it_goes_in() {
    let mut harness = window(vec2(1280.0, 720.0));
    harness.key_press(Key::N);
    steps(&mut harness, 3);
    save(&mut harness, "pantry");
    harness.get_by_label("Marbled beef steak").click();
    steps(&mut harness, 2);
    harness.get_by_label("Set out").click();
    steps(&mut harness, 3);
    save(&mut harness, "marbled");
    assert_eq!(harness.state().session().shown_piece().expect("steak").kind, "beef-marbled");
}

#[test]
fn a_recipe_plays_and_a_command_takes_over() {
    let mut harness = window(vec2(1280.0, 720.0));
    let text = "[[step]]\nhob_w = 1100\n[[step]]\nafter_s = 60\nend = true\n";
    harness.state_mut().open_recipe(text, "own.toml");
    steps(&mut harness, 4);
    assert_eq!(harness.state().session().kitchen.hob_w(), 1100.0);
    assert!(harness.state().session().runner.is_some());
    save(&mut harness, "recipe");
    harness.get_by_label("off").click();
    steps(&mut harness, 2);
    assert!(harness.state().session().runner.is_none());
}

#[test]
fn a_refused_command_says_why_and_one_that_comes_while_the_hand_is_busy_is_carried_out_after_it() {
    let mut harness = window(vec2(1280.0, 720.0));
    harness.key_press(Key::F);
    steps(&mut harness, 2);
    harness.get_by_label_contains("is not in the pan");
    press(&mut harness, Key::A);
    cook(&mut harness, 2.0);
    harness.key_press(Key::F);
    harness.step();
    harness.key_press(Key::O);
    harness.step();
    let kitchen = &harness.state().session().kitchen;
    assert!(kitchen.busy() && kitchen.pieces()[0].in_pan(), "it is still being turned");
    cook(&mut harness, 6.0);
    let piece = &harness.state().session().kitchen.pieces()[0];
    assert!(piece.upside_down() && matches!(piece.place, Place::Rest(_)));
    assert!(harness.state().session().kitchen.blocked().is_empty());
}

#[test]
fn a_phone_shows_the_scene_and_one_drawer() {
    let mut harness = window(vec2(390.0, 844.0));
    save(&mut harness, "phone-cook");
    harness.get_by_label("Inside").click();
    steps(&mut harness, 12);
    save(&mut harness, "phone-inside");
    harness.get_by_label("Food").click();
    steps(&mut harness, 3);
    save(&mut harness, "phone-steak");
}

#[test]
fn every_control_has_a_name_for_assistive_technology() {
    let mut harness = window(vec2(1280.0, 720.0));
    harness.key_press(Key::N);
    harness.key_press(Key::X);
    steps(&mut harness, 4);
    let roles = [
        egui::accesskit::Role::Button,
        egui::accesskit::Role::Slider,
        egui::accesskit::Role::RadioButton,
        egui::accesskit::Role::ComboBox,
    ];
    let mut seen = 0;
    for role in roles {
        for node in harness.get_all_by_role(role) {
            let named = node.accesskit_node().label().is_some_and(|l| !l.trim().is_empty());
            assert!(named, "a {role:?} without a name");
            seen += 1;
        }
    }
    assert!(seen > 25, "only {seen} controls found");
}

#[test]
fn the_scene_is_never_drawn_small_on_a_usual_window() {
    let mut harness = window(vec2(1280.0, 720.0));
    harness.state_mut().session_mut().command(&Command::Hob(400.0)).expect("hob");
    steps(&mut harness, 3);
    let [w, h] = harness.state().scene_size();
    assert!(w >= 960 && h >= 540, "{w} × {h}");
}

fn steak(harness: &Harness<'static, SauteApp>) -> Pos2 {
    harness.state().shown_on_screen(WINDOW).expect("steak in view")
}

/// Food that hangs over the pan falls to where the pointer shows, and no 5 cm nearer to the eye.
#[test]
fn food_that_is_dragged_into_the_pan_falls_to_where_the_pointer_shows() {
    let mut harness = window(vec2(1280.0, 720.0));
    let on_board = steak(&harness);
    drag(&mut harness, on_board, pos2(370.0, 305.0));
    let place = harness.state().session().shown_piece().expect("steak").place;
    assert!(matches!(place, Place::Pan([x, y]) if x.abs() < 0.05 && y.abs() < 0.03), "{place:?}");
}

#[test]
fn the_mouse_puts_flips_carries_and_orbits() {
    let mut harness = window(vec2(1280.0, 720.0));
    let on_board = steak(&harness);
    click(&mut harness, on_board);
    assert!(harness.state().session().shown_piece().expect("steak").in_pan(), "a click puts it in");
    let (in_pan, down) = (steak(&harness), harness.state().session().shown_piece().expect("steak").upside_down());
    click(&mut harness, in_pan);
    cook(&mut harness, 2.0);
    assert_ne!(harness.state().session().shown_piece().expect("steak").upside_down(), down, "a click flips it");
    let in_pan = steak(&harness);
    drag(&mut harness, in_pan, on_board);
    cook(&mut harness, 2.0);
    assert!(!harness.state().session().shown_piece().expect("steak").in_pan(), "it is dragged onto the board");
    let lying = steak(&harness);
    drag(&mut harness, lying, in_pan);
    cook(&mut harness, 2.0);
    assert!(harness.state().session().shown_piece().expect("steak").in_pan(), "it is dragged into the pan");
    let before = steak(&harness);
    drag(&mut harness, pos2(90.0, 480.0), pos2(240.0, 440.0));
    assert!((steak(&harness) - before).length() > 5.0, "a drag beside it turns the view");
}

#[test]
fn the_cut_is_dragged_by_its_knob() {
    let mut harness = window(vec2(1280.0, 720.0));
    harness.key_press(Key::A);
    steps(&mut harness, 14);
    harness.key_press(Key::X);
    steps(&mut harness, 2);
    let [_, knob] = harness.state().cut_handle_on_screen(WINDOW).expect("knob in view");
    drag(&mut harness, knob, knob + vec2(40.0, 14.0));
    let slice = harness.state().slice().expect("cut");
    assert!(slice > 0.1, "{slice}");
    let [_, now] = harness.state().cut_handle_on_screen(WINDOW).expect("knob in view");
    assert!((now - knob - vec2(40.0, 14.0)).length() < 25.0, "the knob follows the mouse: {knob:?} {now:?}");
}

#[derive(Debug)]
struct Dropped(&'static str);

impl egui::DroppedFile for Dropped {
    fn path(&self) -> &std::path::Path {
        std::path::Path::new("dropped.toml")
    }

    fn bytes(&self) -> Result<Vec<u8>, String> {
        Ok(self.0.as_bytes().to_vec())
    }
}

#[test]
fn a_dropped_recipe_plays_and_a_broken_one_is_explained() {
    let mut harness = window(vec2(1280.0, 720.0));
    harness
        .input_mut()
        .dropped_files
        .push(std::sync::Arc::new(Dropped("[[step]]\nhob_w = 400\n[[step]]\nafter_s = 9\nend = true\n")));
    steps(&mut harness, 4);
    assert_eq!(harness.state().session().kitchen.hob_w(), 400.0);
    harness.input_mut().dropped_files.push(std::sync::Arc::new(Dropped("[[step]]\nhob = 400\n")));
    steps(&mut harness, 2);
    harness.get_by_label_contains("dropped.toml:2");
}

/// What the window remembers.
#[derive(Default)]
pub struct Memory(pub std::collections::BTreeMap<String, String>);

impl eframe::Storage for Memory {
    fn get_string(&self, key: &str) -> Option<String> {
        self.0.get(key).cloned()
    }

    fn set_string(&mut self, key: &str, value: String) {
        self.0.insert(key.to_owned(), value);
    }

    fn remove_string(&mut self, key: &str) {
        self.0.remove(key);
    }

    fn flush(&mut self) {}
}

#[test]
fn settings_are_remembered() {
    let mut harness = window(vec2(1280.0, 720.0));
    for key in [Key::C, Key::Num2, Key::M, Key::CloseBracket] {
        harness.key_press(key);
        steps(&mut harness, 2);
    }
    let mut memory = Memory::default();
    eframe::App::save(harness.state_mut(), &mut memory);
    let stored = memory.0.into_values().next();
    let again = SauteApp::start(&egui::Context::default(), None, stored, Start::default()).expect("starts");
    assert_eq!(again.settings(), harness.state().settings());
    assert!(again.settings().fahrenheit && again.settings().view == View::Temperature && again.session().speed == 2.0);
    let broken = SauteApp::start(&egui::Context::default(), None, Some("{ not json".into()), Start::default());
    assert!(broken.is_ok(), "broken settings are left aside");
}

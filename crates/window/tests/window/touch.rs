//! Promise: a window without mouse and keys is used by fingers: one moves the pan, two the eye, one held still shows what is under
//! it; every control is as high as a thumb is wide.

use egui::{Event, Pos2, Rect, TouchPhase, accesskit::Role, pos2, vec2};
use egui_kittest::{
    Harness,
    kittest::{NodeT, Queryable},
};
use glam::Vec3;
use saute_window::SauteApp;
use saute_window::ui::layout::Layout;
use saute_window::ui::theme::TOUCH;

use crate::harness::{cook, press, save, steps, window};

const PHONE: egui::Vec2 = egui::vec2(390.0, 844.0);
const PHONE_RECT: Rect = Rect { min: Pos2::ZERO, max: pos2(390.0, 844.0) };

fn fingers(harness: &mut Harness<'static, SauteApp>, places: &[Pos2], phase: TouchPhase) {
    for (number, &pos) in places.iter().enumerate() {
        let (device_id, id) = (egui::TouchDeviceId(1), egui::TouchId(number as u64 + 1));
        harness.event(Event::Touch { device_id, id, phase, pos, force: None });
    }
    steps(harness, 2);
}

/// Lays a finger down; the first one is the pointer, too.
fn lay(harness: &mut Harness<'static, SauteApp>, at: Pos2) {
    harness.hover_at(at);
    harness.drag_at(at);
    fingers(harness, &[at], TouchPhase::Start);
}

fn lift(harness: &mut Harness<'static, SauteApp>, at: Pos2) {
    harness.drop_at(at);
    fingers(harness, &[at], TouchPhase::End);
    harness.remove_cursor();
    steps(harness, 2);
}

/// A window that has been touched outside of all controls.
fn touched(size: egui::Vec2) -> Harness<'static, SauteApp> {
    let mut harness = window(size);
    let beside = pos2(4.0, 0.3 * size.y);
    lay(&mut harness, beside);
    lift(&mut harness, beside);
    harness
}

fn held(harness: &Harness<'static, SauteApp>) -> saute_kitchen::dynamics::Pose {
    harness.state().session().kitchen.held_pan()
}

#[test]
fn one_finger_moves_the_pan_and_two_the_eye() {
    let mut harness = touched(PHONE);
    let seen = |harness: &Harness<'static, SauteApp>| {
        [0.0, 0.1].map(|x| harness.state().on_screen(Vec3::new(x, 0.0, 0.0), PHONE_RECT).expect("is seen"))
    };
    let ([middle, edge], pan) = (seen(&harness), held(&harness));
    lay(&mut harness, middle);
    let mut apart = [middle, middle + vec2(40.0, 0.0)];
    fingers(&mut harness, &apart, TouchPhase::Start);
    for _ in 0..8 {
        apart = [apart[0] - vec2(6.0, 0.0), apart[1] + vec2(6.0, 6.0)];
        fingers(&mut harness, &apart, TouchPhase::Move);
    }
    fingers(&mut harness, &apart, TouchPhase::End);
    lift(&mut harness, middle);
    let [now, edge_now] = seen(&harness);
    assert!(now.distance(edge_now) > 1.2 * middle.distance(edge), "fingers apart bring it nearer");
    assert_eq!(held(&harness), pan, "two fingers leave the pan where it is");
    let mut harness = touched(PHONE);
    let shape = *harness.state().session().kitchen.world().pan_shape();
    let rim = Vec3::new(0.0, -shape.rim as f32, shape.height as f32);
    let rim = harness.state().on_screen(rim, PHONE_RECT).expect("is seen");
    lay(&mut harness, rim);
    for step in 1..=8u8 {
        harness.hover_at(rim + vec2(5.0 * f32::from(step), 0.0));
        fingers(&mut harness, &[rim + vec2(5.0 * f32::from(step), 0.0)], TouchPhase::Move);
    }
    assert!(held(&harness).position.x > 0.02, "one finger moves it: {:?}", held(&harness));
    lift(&mut harness, rim + vec2(40.0, 0.0));
}

#[test]
fn a_finger_held_still_on_food_asks_what_it_is_and_does_nothing_to_it() {
    let mut harness = touched(PHONE);
    press(&mut harness, egui::Key::A);
    cook(&mut harness, 1.0);
    let steak = harness.state().shown_on_screen(PHONE_RECT).expect("in view");
    let explained = |h: &Harness<'static, SauteApp>| h.query_by_label_contains(" above, ").map(|node| node.rect());
    lay(&mut harness, steak);
    assert_eq!(explained(&harness), None, "a finger that may tap asks nothing");
    steps(&mut harness, 20);
    let words = explained(&harness).expect("is explained");
    assert!(words.bottom() < steak.y, "the hand covers it: {words:?}");
    save(&mut harness, "touch-explained");
    lift(&mut harness, steak);
    assert_eq!(explained(&harness), None);
    let piece = &harness.state().session().kitchen.pieces()[0];
    assert!(piece.in_pan() && !piece.upside_down() && !harness.state().session().kitchen.hand().is_active());
    // A button is explained, too, and is not pressed.
    let flip = harness.get_by_label("Flip").rect().center();
    lay(&mut harness, flip);
    steps(&mut harness, 20);
    harness.get_by_label_contains("flip: selected or middle one (F)");
    lift(&mut harness, flip);
    cook(&mut harness, 3.0);
    assert!(!harness.state().session().kitchen.pieces()[0].upside_down());
    // A tap turns it over.
    lay(&mut harness, flip);
    lift(&mut harness, flip);
    cook(&mut harness, 3.0);
    assert!(harness.state().session().kitchen.pieces()[0].upside_down());
}

/// Controls that a thumb could miss: those that are seen in the panels or on a card and are lower than a thumb is wide.
fn too_low(harness: &Harness<'static, SauteApp>, size: egui::Vec2) -> Vec<String> {
    use Role::{Button, CheckBox, ComboBox, RadioButton, Slider, SpinButton, TextInput};
    let whole = Rect::from_min_size(Pos2::ZERO, size);
    let mut places = Layout::used_by(whole, harness.state().settings(), (true, false)).panels();
    if harness.state().settings_are_open() || harness.state().help_is_open() {
        places = vec![whole.shrink(24.0)];
    }
    let roles = [Button, CheckBox, ComboBox, RadioButton, Slider, SpinButton, TextInput];
    let nodes = harness.root().children_recursive().filter(|n| roles.contains(&n.accesskit_node().role()));
    let named = nodes.map(|n| (n.accesskit_node().label().unwrap_or_default(), n.rect()));
    let seen = named.filter(|(_, rect)| places.iter().any(|place| place.contains_rect(*rect)));
    let low = seen.filter(|(_, rect)| rect.height() < TOUCH - 0.01);
    low.map(|(label, rect)| format!("{label}: {:.0} × {:.0}", rect.width(), rect.height())).collect()
}

#[test]
fn every_control_is_as_high_as_a_thumb_is_wide_once_a_finger_was_seen() {
    for (size, name) in [(PHONE, "upright"), (vec2(844.0, 390.0), "lying"), (vec2(1180.0, 820.0), "tablet")] {
        let mut harness = touched(size);
        let mut low = Vec::new();
        for part in ["Pieces", "Food", "Inside", "Cook"] {
            harness.get_all_by_label(part).next().expect("a part of the drawer").click();
            steps(&mut harness, 3);
            save(&mut harness, &format!("touch-{name}-{part}"));
            low.extend(too_low(&harness, size).into_iter().map(|control| format!("{part}: {control}")));
        }
        press(&mut harness, egui::Key::Num2);
        for key in [egui::Key::F2, egui::Key::F1] {
            press(&mut harness, key);
            low.extend(too_low(&harness, size).into_iter().map(|control| format!("{key:?}: {control}")));
            press(&mut harness, egui::Key::Escape);
        }
        assert!(low.is_empty(), "{name}: {low:#?}");
    }
}

#[test]
fn what_there_is_to_learn_is_under_the_thumb_on_a_phone_in_every_language() {
    for language in saute_words::language::Language::all() {
        let mut harness = touched(PHONE);
        harness.state_mut().set_language(language);
        steps(&mut harness, 14);
        let [learn, settings, said] = ["learn.title", "settings.title", "messages.title"].map(|key| language.text(key));
        let drawer = Layout::used_by(PHONE_RECT, harness.state().settings(), (true, false)).bottom;
        for name in [learn, settings, said] {
            let rect = harness.get_by_label(name).rect();
            assert!(drawer.contains_rect(rect) && rect.height() >= TOUCH - 0.01, "{name}: {rect:?} in {drawer:?}");
        }
        save(&mut harness, &format!("touch-learn-bar-{language:?}"));
        harness.get_by_label(learn).click();
        steps(&mut harness, 20);
        save(&mut harness, &format!("touch-learn-{language:?}"));
        let places = ["tutorial.title", "goals.title", "plan.title", "lesson.title", "athome.title", "help.title"];
        for key in places {
            let rect = harness.get_by_label(language.text(key)).rect();
            assert!(PHONE_RECT.contains_rect(rect) && rect.height() >= TOUCH - 0.01, "{key}: {rect:?}");
        }
        harness.get_by_label(language.text("help.title")).click();
        steps(&mut harness, 3);
        assert!(harness.state().help_is_open(), "{language:?}");
    }
}

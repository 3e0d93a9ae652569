//! Promise: many pieces, the moving pan and both hands are at home in the window.

use egui::{Event, Key, Modifiers, Rect, pos2, vec2};
use egui_kittest::{Harness, kittest::Queryable};
use glam::Vec3;
use saute_kitchen::Place;
use saute_window::SauteApp;

use crate::harness::{WINDOW, click, cook, drag, press, save, steps, window};

const WIDE: egui::Vec2 = egui::vec2(1280.0, 720.0);
const PHONE: egui::Vec2 = egui::vec2(390.0, 844.0);

/// A window with food added to the steak by the pantry.
fn with_more(food: &str, count: usize) -> Harness<'static, SauteApp> {
    let mut harness = window(WIDE);
    press(&mut harness, Key::N);
    harness.get_by_label(food).click();
    steps(&mut harness, 2);
    harness.state_mut().set_count(count);
    steps(&mut harness, 2);
    harness.get_by_label(&format!("Add {count}")).click();
    steps(&mut harness, 3);
    harness
}

fn in_pan(harness: &Harness<'static, SauteApp>) -> usize {
    harness.state().session().kitchen.pieces().iter().filter(|p| p.in_pan()).count()
}

fn pan_at(harness: &Harness<'static, SauteApp>) -> glam::DVec3 {
    harness.state().session().kitchen.world().motion.pose.position
}

fn hold(harness: &mut Harness<'static, SauteApp>, key: Key, modifiers: Modifiers, pressed: bool) {
    let now = if pressed { modifiers } else { Modifiers::NONE };
    harness.event(Event::ModifiersChanged(now));
    harness.event(Event::Key { key, physical_key: None, pressed, repeat: false, modifiers });
}

#[test]
fn several_kinds_are_added_laid_in_and_taken_away() {
    let mut harness = with_more("Carrot coin", 9);
    let ids: Vec<String> = harness.state().session().kitchen.pieces().iter().map(|p| p.id.clone()).collect();
    assert_eq!(ids[0], "steak");
    assert_eq!((ids[1].as_str(), ids[9].as_str(), ids.len()), ("carrot-coin.1", "carrot-coin.9", 10));
    save(&mut harness, "pantry-added");
    press(&mut harness, Key::A);
    steps(&mut harness, 14);
    assert_eq!(in_pan(&harness), 9, "P lays the whole group in");
    press(&mut harness, Key::B);
    save(&mut harness, "pieces");
    harness.get_by_label_contains("Unfold carrot coin").click();
    steps(&mut harness, 3);
    save(&mut harness, "pieces-unfolded");
    harness.get_by_label_contains("Select carrot coin no. 3").click();
    steps(&mut harness, 12);
    assert_eq!(harness.state().session().shown_piece().expect("a piece").id, "carrot-coin.3");
    assert!(harness.query_all_by_label_contains("Tenderness").count() > 0);
    harness.get_by_label("Take away").click();
    steps(&mut harness, 3);
    assert_eq!(harness.state().session().kitchen.pieces().len(), 1);
}

#[test]
fn what_does_not_fit_is_counted_and_can_be_heaped() {
    let mut harness = with_more("Carrot coin", 35);
    press(&mut harness, Key::A);
    let lying = in_pan(&harness);
    assert!(lying > 10 && lying < 35, "{lying}");
    harness.get_by_label_contains(&format!("{lying} of 35 fit beside each other"));
    save(&mut harness, "full-pan");
    harness.get_by_label("In a heap").click();
    cook(&mut harness, 2.0);
    assert!(in_pan(&harness) > 30, "{}", in_pan(&harness));
    save(&mut harness, "heap");
}

#[test]
fn a_piece_under_the_pointer_is_read_out() {
    let mut harness = window(WIDE);
    let at = harness.state().shown_on_screen(WINDOW).expect("in view");
    harness.hover_at(at);
    steps(&mut harness, 3);
    harness.get_by_label_contains("surface 5");
    save(&mut harness, "read-out");
    harness.hover_at(pos2(300.0, 560.0));
    steps(&mut harness, 3);
    assert!(harness.query_by_label_contains("surface 5").is_none());
}

#[test]
fn the_pan_is_dragged_by_its_rim_and_slides_home_when_let_go_near_its_ring() {
    let mut harness = window(WIDE);
    harness.get_by_label("Front").click();
    steps(&mut harness, 24);
    let rim = harness.state().on_screen(Vec3::new(-0.13, 0.0, 0.045), WINDOW).expect("in view");
    drag(&mut harness, rim, rim + vec2(-150.0, 0.0));
    assert!(pan_at(&harness).x < -0.05, "{}", pan_at(&harness));
    save(&mut harness, "pan-dragged");
    let moved = pan_at(&harness).as_vec3();
    let rim = harness.state().on_screen(moved + Vec3::new(-0.13, 0.0, 0.042), WINDOW).expect("in view");
    let home = harness.state().on_screen(Vec3::new(-0.145, 0.0, 0.045), WINDOW).expect("in view");
    drag(&mut harness, rim, home);
    steps(&mut harness, 20);
    assert!(pan_at(&harness).truncate().length() < 1e-6, "{}", pan_at(&harness));
}

#[test]
fn held_keys_move_tilt_and_shake_the_pan() {
    let mut harness = window(WIDE);
    press(&mut harness, Key::A);
    hold(&mut harness, Key::D, Modifiers::SHIFT, true);
    steps(&mut harness, 8);
    hold(&mut harness, Key::D, Modifiers::SHIFT, false);
    steps(&mut harness, 10);
    let moved = pan_at(&harness);
    assert!(moved.x > 0.06 && moved.x < 0.2, "{moved}");
    assert_eq!(harness.state().settings().scale, "paper-2013", "with Shift a letter does nothing else");
    hold(&mut harness, Key::Z, Modifiers::SHIFT, true);
    steps(&mut harness, 14);
    let up = harness.state().session().kitchen.world().motion.pose.rotation * glam::DVec3::Z;
    assert!(up.x < -0.2, "left side down: {up}");
    save(&mut harness, "tilted");
    hold(&mut harness, Key::Z, Modifiers::SHIFT, false);
    steps(&mut harness, 20);
    let up = harness.state().session().kitchen.world().motion.pose.rotation * glam::DVec3::Z;
    assert!(up.z > 0.9999, "{up}");
    hold(&mut harness, Key::K, Modifiers::NONE, true);
    steps(&mut harness, 20);
    assert!(harness.state().session().kitchen.gesture().is_some());
    hold(&mut harness, Key::K, Modifiers::NONE, false);
    steps(&mut harness, 3);
    assert!(harness.state().session().kitchen.gesture().is_none(), "it ends with the key");
}

#[test]
fn a_toss_throws_what_is_in_the_pan_and_an_empty_pan_says_so() {
    let mut harness = with_more("Carrot coin", 7);
    press(&mut harness, Key::T);
    harness.get_by_label_contains("nothing in the pan to toss");
    press(&mut harness, Key::A);
    press(&mut harness, Key::N);
    cook(&mut harness, 1.0);
    press(&mut harness, Key::T);
    let mut highest = 0.0f64;
    for k in 0..24 {
        steps(&mut harness, 1);
        let pieces = harness.state().session().kitchen.pieces().iter().filter(|p| p.is_out());
        highest = pieces.map(|p| p.pose.position.z).fold(highest, f64::max);
        if [8, 12].contains(&k) {
            save(&mut harness, &format!("toss-{k}"));
        }
    }
    assert!(highest > 0.04, "{highest}");
}

#[test]
fn tongs_lead_a_piece_that_is_dragged_and_lay_it_down() {
    let mut harness = with_more("Shrimp", 2);
    press(&mut harness, Key::A);
    cook(&mut harness, 1.0);
    let id = "shrimp.1";
    let from = harness.state().piece_on_screen(id, WINDOW).expect("in view");
    let before = harness.state().session().kitchen.piece(id).expect("a shrimp").pose.position;
    let to = from + vec2(0.0, -60.0);
    harness.hover_at(from);
    harness.step();
    harness.drag_at(from);
    for k in 1..=10u8 {
        harness.hover_at(from + (to - from) * (f32::from(k) / 10.0));
        harness.step();
    }
    let held = harness.state().session().kitchen.piece(id).expect("a shrimp").key;
    assert_eq!(harness.state().session().kitchen.hand().gripped(), Some(held));
    save(&mut harness, "led");
    harness.drop_at(to);
    cook(&mut harness, 2.0);
    let piece = harness.state().session().kitchen.piece(id).expect("a shrimp");
    assert!(matches!(piece.place, Place::Pan(_)), "{:?}", piece.place);
    assert!((piece.pose.position - before).truncate().length() > 0.02, "{}", piece.pose.position);
    assert!(!harness.state().session().kitchen.hand().is_active());
}

#[test]
fn a_click_selects_the_piece_that_the_panels_show() {
    let mut harness = with_more("Shrimp", 3);
    press(&mut harness, Key::A);
    cook(&mut harness, 1.0);
    let at = harness.state().piece_on_screen("shrimp.2", WINDOW).expect("in view");
    click(&mut harness, at);
    assert_eq!(harness.state().session().shown_piece().expect("a piece").id, "shrimp.2");
}

#[test]
fn the_list_is_reachable_on_a_phone_and_nothing_overlaps() {
    let mut harness = window(PHONE);
    harness.get_by_label("Pieces").click();
    steps(&mut harness, 4);
    harness.get_by_label_contains("Select steak");
    save(&mut harness, "phone-pieces");
    let tabs = ["Cook", "Inside", "Food", "Pieces", "Settings", "Learn"];
    let rects: Vec<Rect> = tabs.iter().map(|tab| harness.get_by_label(tab).rect()).collect();
    for (i, a) in rects.iter().enumerate() {
        assert!(a.right() <= PHONE.x - 10.0, "{} reaches {}", tabs[i], a.right());
        assert!(rects[i + 1..].iter().all(|b| !a.shrink(0.5).intersects(*b)), "{} overlaps", tabs[i]);
    }
}

fn pan_state<'a>(harness: &'a Harness<'static, SauteApp>) -> &'a saute_kitchen::pan::PanState {
    harness.state().session().kitchen.pan_state()
}

#[test]
fn oil_butter_and_water_are_poured_by_button_and_key_and_the_lid_refuses_them() {
    for (size, name) in [(WIDE, "pour"), (PHONE, "phone-pour")] {
        let mut harness = window(size);
        let film = pan_state(&harness).oil_mass();
        harness.get_by_label("Oil 5 g").click();
        steps(&mut harness, 3);
        assert!((pan_state(&harness).oil_mass() - film - 0.005).abs() < 1e-9);
        harness.get_by_label("little").click();
        steps(&mut harness, 3);
        harness.get_by_label("Water 100 g").click();
        press(&mut harness, Key::Num9);
        let liquids = &pan_state(&harness).liquids;
        assert!((liquids.butter.lump.as_ref().expect("a lump").mass - 0.025).abs() < 1e-9);
        assert!((pan_state(&harness).water_mass() - 0.1).abs() < 1e-3);
        save(&mut harness, name);
        harness.get_by_label_contains("25\u{a0}g butter");
        press(&mut harness, Key::Z);
        assert!(pan_state(&harness).lid.is_some());
        let oil = pan_state(&harness).oil_mass();
        press(&mut harness, Key::Num8);
        harness.get_by_label_contains("the lid is on: take it off first");
        assert_eq!(pan_state(&harness).oil_mass(), oil);
        save(&mut harness, &format!("{name}-lid"));
        harness.get_by_label("Lid").click();
        steps(&mut harness, 3);
        assert!(pan_state(&harness).lid.is_none());
    }
}

#[test]
fn the_controls_of_the_bottom_bar_lie_within_the_window() {
    for size in [WIDE, PHONE] {
        let mut harness = window(size);
        press(&mut harness, Key::U);
        let labels = ["Oil 5 g", "Butter 10 g", "Water 30 g", "little", "Lid", "Turner"];
        for label in labels {
            let rect = harness.get_by_label(label).rect();
            assert!(rect.left() >= 0.0 && rect.right() <= size.x - 10.0, "{label} {rect:?} in {size}");
            assert!(rect.bottom() <= size.y, "{label} {rect:?} in {size}");
        }
        save(&mut harness, &format!("bar-{}", size.x));
    }
}

#[test]
fn oil_past_its_smoke_point_is_warned_of() {
    let mut harness = window(WIDE);
    press(&mut harness, Key::Num8);
    harness.state_mut().session_mut().command(&saute_kitchen::Command::Hob(1800.0)).expect("hob");
    let mut seconds = 0.0;
    while pan_state(&harness).smoke_mg_s() < 0.6 && seconds < 300.0 {
        cook(&mut harness, 5.0);
        seconds += 5.0;
    }
    harness.get_by_label_contains("the oil smokes: turn the hob down (");
    save(&mut harness, "smoke-warning");
}

/// Moves the pointer in steps.
fn move_pointer(harness: &mut Harness<'static, SauteApp>, from: egui::Pos2, to: egui::Pos2) {
    for k in 1..=12u8 {
        harness.hover_at(from + (to - from) * (f32::from(k) / 12.0));
        harness.step();
    }
}

#[test]
fn the_mouse_leads_the_turner_under_the_steak_lifts_it_and_the_pan_moves_meanwhile() {
    let mut harness = window(WIDE);
    press(&mut harness, Key::A);
    cook(&mut harness, 1.0);
    press(&mut harness, Key::U);
    let before = harness.state().session().kitchen.pieces()[0].pose.position;
    let start = harness.state().on_screen(Vec3::new(0.0, -0.085, 0.003), WINDOW).expect("in view");
    let under = harness.state().on_screen(Vec3::new(0.0, -0.02, 0.003), WINDOW).expect("in view");
    harness.hover_at(start);
    harness.step();
    harness.drag_at(start);
    harness.step();
    move_pointer(&mut harness, start, under);
    steps(&mut harness, 10);
    save(&mut harness, "turner-under");
    let kitchen = &harness.state().session().kitchen;
    assert_eq!(kitchen.led_tool(), Some(saute_kitchen::dynamics::Tool::Turner));
    assert!(
        (kitchen.pieces()[0].pose.position - before).length() < 0.02,
        "{before} {}",
        kitchen.pieces()[0].pose.position
    );
    for _ in 0..14 {
        let delta = vec2(0.0, 50.0);
        let (unit, phase) = (egui::MouseWheelUnit::Point, egui::TouchPhase::Move);
        let source = egui::MouseWheelSource::Wheel;
        harness.event(Event::MouseWheel { unit, delta, phase, source, modifiers: Modifiers::NONE });
        harness.step();
    }
    hold(&mut harness, Key::D, Modifiers::SHIFT, true);
    steps(&mut harness, 10);
    hold(&mut harness, Key::D, Modifiers::SHIFT, false);
    steps(&mut harness, 6);
    save(&mut harness, "turner-lifts");
    let kitchen = &harness.state().session().kitchen;
    let height = kitchen.pieces()[0].pose.position.z - before.z;
    assert!(height > 0.03, "lifted by {height}");
    assert!(pan_at(&harness).x > 0.05, "{}", pan_at(&harness));
    harness.drop_at(under);
    steps(&mut harness, 10);
    assert!(harness.state().session().kitchen.hand().is_active(), "the turner stays where it is left");
    press(&mut harness, Key::Backspace);
    cook(&mut harness, 3.0);
    assert!(!harness.state().session().kitchen.hand().is_active());
}

#[test]
fn a_gamepad_moves_pan_and_tool_together_and_its_buttons_act() {
    use saute_controls::input::gamepad::{PadButton, PadState};
    let mut harness = window(WIDE);
    press(&mut harness, Key::A);
    cook(&mut harness, 1.0);
    press(&mut harness, Key::U);
    harness.state_mut().set_pad(PadState { left: [-1.0, 0.0], right: [0.0, 1.0], ..PadState::default() });
    steps(&mut harness, 8);
    harness.state_mut().set_pad(PadState::default());
    steps(&mut harness, 8);
    assert!(pan_at(&harness).x < -0.05, "{}", pan_at(&harness));
    assert!(harness.state().session().kitchen.hand().is_active());
    save(&mut harness, "gamepad");
    let mut down = PadState::default();
    for button in [PadButton::Up, PadButton::East, PadButton::Start] {
        down.down[button as usize] = true;
    }
    let hob = harness.state().session().kitchen.hob_w();
    harness.state_mut().set_pad(down);
    steps(&mut harness, 3);
    assert!(harness.state().session().kitchen.hob_w() > hob && harness.state().session().paused);
    harness.state_mut().set_pad(PadState::default());
    press(&mut harness, Key::F1);
    harness.get_by_label_contains("move the tool");
    save(&mut harness, "help");
}

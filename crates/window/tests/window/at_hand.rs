//! Promise: everything is at hand and stays where it is: controls, views of the eye, messages, the help, the recipe.

use egui::{Key, Rect, accesskit::Role, pos2, vec2};
use egui_kittest::{
    Harness,
    kittest::{NodeT, Queryable},
};
use saute_controls::act::{Act, TimeAct};
use saute_window::SauteApp;
use saute_window::ui::layout::Layout;

use crate::harness::{WINDOW, cook, drag, drawn_words, press, save, steps, window};

/// Controls that lie wholly in one of the panels.
fn controls(harness: &Harness<'static, SauteApp>, size: egui::Vec2) -> Vec<(String, Rect)> {
    let whole = Rect::from_min_size(pos2(0.0, 0.0), size);
    let panels = Layout::new(whole, harness.state().settings()).panels();
    let roles = [Role::Button, Role::RadioButton, Role::ComboBox];
    let nodes = harness.root().children_recursive().filter(|n| roles.contains(&n.accesskit_node().role()));
    let named = nodes.map(|n| (n.accesskit_node().label().unwrap_or_default(), n.rect()));
    named.filter(|(_, rect)| panels.iter().any(|panel| panel.contains_rect(*rect))).collect()
}

#[test]
fn no_control_lies_on_another_on_a_desk_or_on_a_phone() {
    for (size, name) in [(vec2(1280.0, 720.0), "wide"), (vec2(390.0, 844.0), "upright"), (vec2(844.0, 390.0), "lying")]
    {
        let mut harness = window(size);
        for language in saute_words::language::Language::all() {
            harness.state_mut().set_language(language);
            steps(&mut harness, 14);
            save(&mut harness, &format!("at-hand-{name}-{language:?}"));
            let all = controls(&harness, size);
            assert!(all.len() > 15, "{name}: {}", all.len());
            for (i, (label, rect)) in all.iter().enumerate() {
                let on = |(_, other): &&(String, Rect)| rect.shrink(1.0).intersects(other.shrink(1.0));
                let hit: Vec<_> = all[i + 1..].iter().filter(on).collect();
                assert!(hit.is_empty(), "{name} {language:?}: {label} {rect:?} on {hit:?}");
            }
        }
    }
}

#[test]
fn nothing_jumps_when_a_tool_a_recipe_or_a_warning_comes() {
    let mut harness = window(vec2(1280.0, 720.0));
    let places = |h: &Harness<'static, SauteApp>| {
        ["Pause", "Lid", "Flip", "Look", "Settings", "1100 W"].map(|label| h.get_by_label(label).rect())
    };
    let before = places(&harness);
    press(&mut harness, Key::A);
    harness.get_by_label("Tongs").click();
    steps(&mut harness, 3);
    let steak = harness.state().shown_on_screen(WINDOW).expect("in view");
    drag(&mut harness, steak + vec2(-90.0, 60.0), steak + vec2(-60.0, 40.0));
    harness.get_by_label("Put away");
    save(&mut harness, "turner-strip");
    harness.get_by_label("Turner").click();
    steps(&mut harness, 2);
    harness.state_mut().session_mut().command(&saute_kitchen::Command::Hob(2000.0)).expect("hob");
    cook(&mut harness, 200.0);
    assert_eq!(places(&harness)[1..], before[1..]);
    let text = "[[step]]\nhob_w = 1100\n[[step]]\nafter_s = 60\nend = true\n";
    harness.state_mut().open_recipe(text, "own.toml");
    steps(&mut harness, 3);
    assert_eq!(places(&harness), before);
}

#[test]
fn the_hob_is_a_slider_with_its_settings_marked() {
    let mut harness = window(vec2(1280.0, 720.0));
    let [off, most] = ["off", "2000 W"].map(|label| harness.get_by_label(label).rect().center());
    let track = harness.get_by_label("Hob power").rect();
    let at = |share: f32| pos2(off.x + share * (most.x - off.x), track.center().y);
    drag(&mut harness, at(0.0), at(0.75));
    let power = harness.state().session().kitchen.hob_w();
    assert!((power - 1500.0).abs() < 60.0, "{power}");
    harness.get_by_label("400 W").click();
    steps(&mut harness, 2);
    assert_eq!(harness.state().session().kitchen.hob_w(), 400.0);
}

#[test]
fn what_is_taken_out_and_halved_is_looked_at_beside_the_panels() {
    let mut harness = window(vec2(1280.0, 720.0));
    let free = |h: &Harness<'static, SauteApp>| Layout::new(WINDOW, h.state().settings()).free;
    press(&mut harness, Key::A);
    cook(&mut harness, 60.0);
    let before = harness.state().shown_on_screen(WINDOW).expect("in view");
    press(&mut harness, Key::O);
    cook(&mut harness, 4.0);
    steps(&mut harness, 20);
    save(&mut harness, "eye-out");
    let out = harness.state().shown_on_screen(WINDOW).expect("in view");
    assert!(free(&harness).shrink(120.0).contains(out), "{out:?} in {:?}", free(&harness));
    harness.get_by_label("Halve").click();
    steps(&mut harness, 24);
    save(&mut harness, "eye-halved");
    let cut = harness.state().shown_on_screen(WINDOW).expect("in view");
    assert!(free(&harness).shrink(120.0).contains(cut), "{cut:?}");
    harness.get_by_label("Front").click();
    steps(&mut harness, 24);
    let pan = harness.state().on_screen(glam::Vec3::ZERO, WINDOW).expect("in view");
    assert!((pan - before).length() < 40.0, "the working view: {pan:?} {before:?}");
    harness.get_by_label("To food").click();
    steps(&mut harness, 24);
    assert!(free(&harness).shrink(120.0).contains(harness.state().shown_on_screen(WINDOW).expect("in view")));
}

/// The food is in the part that no panel covers.
#[track_caller]
fn is_seen(harness: &Harness<'static, SauteApp>, whole: Rect) {
    let at = harness.state().shown_on_screen(whole).expect("in view");
    let free = Layout::new(whole, harness.state().settings()).free;
    assert!(free.shrink(8.0).contains(at), "{at:?} in {free:?}");
}

#[test]
fn food_is_found_again_after_another_cook_and_in_another_time() {
    let size = vec2(390.0, 844.0);
    let (mut harness, whole) = (window(size), Rect::from_min_size(pos2(0.0, 0.0), size));
    save(&mut harness, "sight-start");
    is_seen(&harness, whole);
    press(&mut harness, Key::A);
    cook(&mut harness, 20.0);
    steps(&mut harness, 24);
    is_seen(&harness, whole);
    let in_s = harness.state().session().kitchen.time_s();
    press(&mut harness, Key::O);
    cook(&mut harness, 4.0);
    steps(&mut harness, 24);
    is_seen(&harness, whole);
    let ctx = harness.ctx.clone();
    harness.state_mut().act(Act::Time(TimeAct::TryFrom(in_s - 2.0)), &ctx);
    steps(&mut harness, 40);
    let session = harness.state().session();
    assert!(session.shown_piece().expect("steak").in_pan() && session.has_branches(), "the other way is kept beside");
    is_seen(&harness, whole);
    press(&mut harness, Key::R);
    steps(&mut harness, 40);
    save(&mut harness, "sight-again");
    is_seen(&harness, whole);
}

#[test]
fn what_was_said_is_kept_in_a_list_and_the_help_is_grouped_searched_and_closed_by_a_button() {
    let mut harness = window(vec2(1280.0, 720.0));
    is_seen(&harness, WINDOW);
    messages(&mut harness);
    press(&mut harness, Key::Escape);
    help(&mut harness);
}

fn messages(harness: &mut Harness<'static, SauteApp>) {
    press(harness, Key::F);
    press(harness, Key::T);
    press(harness, Key::F3);
    harness.get_by_label_contains("is not in the pan");
    save(harness, "messages");
    assert!(harness.get_all_by_label_contains("nothing in the pan to toss").count() >= 1);
    harness.get_by_label("Done").click();
    steps(harness, 2);
    harness.get_by_label("Messages").click();
    steps(harness, 2);
    harness.get_by_label_contains("is not in the pan");
}

fn help(harness: &mut Harness<'static, SauteApp>) {
    press(harness, Key::F1);
    for title in ["Food", "Hob and time", "Views of the food", "Camera", "Tools", "Window"] {
        assert!(harness.query_all_by_label(title).next().is_some(), "{title}");
    }
    save(harness, "help");
    harness.get_by_label("search").focus();
    steps(harness, 2);
    harness.get_by_label("search").type_text("butter");
    steps(harness, 3);
    harness.get_by_label("butter into the pan");
    assert!(harness.query_by_label("start over").is_none());
    save(harness, "help-search");
    harness.get_by_label("Done").click();
    steps(harness, 2);
    assert!(!harness.state().help_is_open());
}

#[test]
fn a_recipe_shows_its_progress_and_is_resumed_after_taking_over() {
    let mut harness = window(vec2(1280.0, 720.0));
    let text = "title = \"Own\"\n[[step]]\nhob_w = 1100\n[[step]]\nafter_s = 60\nhob_w = 400\n[[step]]\nafter_s = 60\nend = true\n";
    harness.state_mut().open_recipe(text, "own.toml");
    steps(&mut harness, 3);
    harness.get_by_label("step 1 of 3");
    harness.get_by_label("off").click();
    steps(&mut harness, 2);
    assert!(harness.state().session().runner.is_none());
    save(&mut harness, "resume");
    harness.get_by_label("Resume Own").click();
    steps(&mut harness, 2);
    cook(&mut harness, 61.0);
    assert_eq!(harness.state().session().kitchen.hob_w(), 400.0, "its next step has come");
}

#[test]
fn the_curves_are_zoomed_and_a_double_click_shows_all_of_them() {
    let mut harness = window(vec2(1280.0, 720.0));
    press(&mut harness, Key::G);
    harness.get_by_label("1100 W").click();
    cook(&mut harness, 240.0);
    let plot = harness.get_by_label_contains("Curves of pan").rect();
    let minutes = |h: &mut Harness<'static, SauteApp>| {
        h.hover_at(pos2(plot.left() + 50.0, plot.center().y - 20.0));
        steps(h, 3);
        (0..5u8).find(|m| h.query_all_by_label_contains(&format!("{m}:")).any(|n| n.rect().height() < 30.0))
    };
    assert_eq!(minutes(&mut harness), Some(0));
    harness.hover_at(pos2(plot.right() - 30.0, plot.center().y - 20.0));
    steps(&mut harness, 2);
    (0..6).for_each(|_| {
        harness.event(egui::Event::Zoom(1.5));
        harness.step();
    });
    steps(&mut harness, 6);
    assert!(minutes(&mut harness) >= Some(3), "the left end has moved to the end of the cook");
    save(&mut harness, "curves-zoomed");
    let middle = plot.center() - vec2(0.0, 20.0);
    for _ in 0..2 {
        harness.hover_at(middle);
        harness.drag_at(middle);
        harness.step();
        harness.drop_at(middle);
        harness.step();
    }
    steps(&mut harness, 6);
    assert_eq!(minutes(&mut harness), Some(0), "all of it is shown again");
}

#[test]
fn a_window_that_is_tiny_has_the_picture_and_the_one_button() {
    for size in [vec2(400.0, 300.0), vec2(320.0, 180.0)] {
        let mut harness = window(size);
        steps(&mut harness, 2);
        assert!(harness.query_by_label("Flip").is_none() && harness.query_by_label("?").is_none());
        save(&mut harness, &format!("tiny-{:.0}", size.x));
        let is_button = |node: &egui_kittest::Node<'_>| node.accesskit_node().role() == Role::Button;
        harness.get_all_by_label_contains("1100 W").find(is_button).expect("the one button").click();
        steps(&mut harness, 4);
        assert_eq!(harness.state().session().kitchen.hob_w(), 1100.0);
        let words = drawn_words(&harness);
        assert!(words.iter().any(|words| words.contains("160")), "{words:?}");
    }
}

#[test]
fn a_quick_drag_of_the_hob_counts_from_its_knob_and_from_its_words() {
    let mut harness = window(WINDOW.size());
    let [off, most] = ["off", "2000 W"].map(|name| harness.get_by_label(name).rect().center());
    for up in [0.0, 18.0] {
        harness.hover_at(off - vec2(0.0, up));
        harness.step();
        harness.drag_at(off - vec2(0.0, up));
        harness.step();
        // It is moved and let go within a frame.
        harness.hover_at(most - vec2(0.0, up));
        harness.drop_at(most - vec2(0.0, up));
        steps(&mut harness, 3);
        assert_eq!(harness.state().session().kitchen.hob_w(), 2000.0, "{up}");
        harness.get_by_label("off").click();
        steps(&mut harness, 3);
    }
}

#[test]
fn nothing_moves_in_the_list_of_foods_when_food_is_added() {
    let mut harness = window(WINDOW.size());
    press(&mut harness, Key::N);
    let place = |harness: &Harness<'static, SauteApp>| harness.get_by_label("Ground-beef patty").rect();
    let before = place(&harness);
    harness.state_mut().set_count(9);
    steps(&mut harness, 2);
    harness.get_by_label("Add 9").click();
    steps(&mut harness, 4);
    assert!(harness.query_by_label("Lay all in").is_some());
    assert_eq!(place(&harness), before);
}

#[test]
fn as_many_pieces_are_set_out_as_would_be_added() {
    let mut harness = window(WINDOW.size());
    press(&mut harness, Key::N);
    harness.state_mut().set_count(3);
    steps(&mut harness, 2);
    harness.get_by_label("Set out").click();
    steps(&mut harness, 4);
    let ids: Vec<_> = harness.state().session().kitchen.pieces().iter().map(|piece| piece.id.clone()).collect();
    assert_eq!(ids, ["steak.1", "steak.2", "steak.3"]);
}

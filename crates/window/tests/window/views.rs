//! Promise: every field can be seen, compared with the look, read under the pointer and followed over time.

use egui::{Key, Rect, pos2, vec2};
use egui_kittest::{
    Harness,
    kittest::{NodeT, Queryable},
};
use saute_controls::spoken::view_words::ViewWords;
use saute_picture::View;
use saute_window::SauteApp;
use saute_window::ui::layout::Layout;

use crate::harness::{WINDOW, click, cook, drag, press, save, steps, window};

const KEYS: [Key; 7] = [Key::Num1, Key::Num2, Key::Num3, Key::Num4, Key::Num5, Key::Num6, Key::Num7];

/// A marbled steak that has fried on its first side and lies cut open.
fn fried(size: egui::Vec2) -> Harness<'static, SauteApp> {
    let mut harness = window(size);
    let text = "[pan]\ninitial_c = 210\n[[food]]\nid = \"steak\"\nkind = \"beef-marbled\"\n\
        [[step]]\nhob_w = 800\n[[step]]\nput = \"steak\"\n[[step]]\nafter_s = 200\nflip = \"steak\"\n[[step]]\nafter_s = 900\nend = true\n";
    harness.state_mut().open_recipe(text, "fried.toml");
    cook(&mut harness, 240.0);
    harness.state_mut().session_mut().set_paused(true);
    press(&mut harness, Key::X);
    harness
}

#[test]
fn every_view_has_a_key_a_chip_and_a_legend() {
    let mut harness = fried(vec2(1280.0, 720.0));
    for (view, key) in View::ALL.into_iter().zip(KEYS) {
        press(&mut harness, key);
        steps(&mut harness, 12);
        assert_eq!(harness.state().settings().view, view);
        save(&mut harness, &format!("view-{}", view.name(saute_words::language::Language::ENGLISH).to_lowercase()));
        harness.get_by_label("Look").click();
        steps(&mut harness, 2);
        harness.get_by_label(view.name(saute_words::language::Language::ENGLISH)).click();
        steps(&mut harness, 2);
        assert_eq!(harness.state().settings().view, view);
        if !matches!(view, View::Look | View::Doneness) {
            harness.get_by_label_contains("Legend: ");
        }
    }
}

#[test]
fn a_phone_has_every_view_with_its_legend() {
    let mut harness = fried(vec2(390.0, 844.0));
    for view in View::ALL {
        harness.get_by_label(view.name(saute_words::language::Language::ENGLISH)).click();
        steps(&mut harness, 12);
        assert_eq!(harness.state().settings().view, view);
        save(
            &mut harness,
            &format!("phone-view-{}", view.name(saute_words::language::Language::ENGLISH).to_lowercase()),
        );
    }
}

/// The window's right half of the scene, with the field, and its left half, with the look.
fn panes(harness: &Harness<'static, SauteApp>, size: egui::Vec2) -> [Rect; 2] {
    let whole = Rect::from_min_size(pos2(0.0, 0.0), size);
    let panes = Layout::new(whole, harness.state().settings()).panes(true);
    [panes[0].rect, panes[1].rect]
}

/// Mean colour of a patch of the window.
fn mean(image: &image::RgbaImage, at: egui::Pos2) -> [f64; 3] {
    let mut sum = [0.0; 3];
    for dy in 0..5 {
        for dx in 0..5 {
            let pixel = image.get_pixel(at.x as u32 + dx - 2, at.y as u32 + dy - 2);
            (0..3).for_each(|k| sum[k] += f64::from(pixel[k]) / 25.0);
        }
    }
    sum
}

#[test]
fn split_shows_the_look_and_the_field_of_one_instant_with_one_eye() {
    for size in [vec2(1280.0, 720.0), vec2(390.0, 844.0)] {
        let mut harness = fried(size);
        press(&mut harness, Key::X);
        press(&mut harness, Key::Y);
        assert!(harness.state().settings().is_split());
        assert_eq!(harness.state().settings().view, View::Temperature, "beside the look comes a field");
        press(&mut harness, Key::Num3);
        steps(&mut harness, 12);
        save(&mut harness, if size.x > 700.0 { "split" } else { "phone-split" });
        let [look, field] = panes(&harness, size);
        let at = |rect| harness.state().shown_on_screen(rect).expect("in view");
        let (left, right) = (at(look), at(field));
        assert!(((right - field.min) - (left - look.min)).length() < 1.0, "the same place in both halves");
        let image = harness.render().expect("renders");
        let (seen, moist) = (mean(&image, left), mean(&image, right));
        // The dry crust is dark to the eye and pale in the moisture view.
        assert!(moist[0] > seen[0] + 60.0, "{seen:?} {moist:?}");
        harness.get_by_label("Split").click();
        steps(&mut harness, 2);
        assert!(!harness.state().settings().is_split());
    }
}

#[test]
fn food_is_picked_in_either_half_of_a_split_window() {
    let mut harness = window(vec2(1280.0, 720.0));
    press(&mut harness, Key::A);
    cook(&mut harness, 2.0);
    press(&mut harness, Key::Y);
    for half in panes(&harness, vec2(1280.0, 720.0)) {
        let (at, down) = (harness.state().shown_on_screen(half).expect("in view"), upside_down(&harness));
        click(&mut harness, at);
        cook(&mut harness, 3.0);
        assert_ne!(upside_down(&harness), down, "a click in {half:?} flips it");
    }
}

fn upside_down(harness: &Harness<'static, SauteApp>) -> bool {
    harness.state().session().shown_piece().expect("steak").upside_down()
}

#[test]
fn the_pointer_tells_the_value_of_the_view_with_its_unit() {
    let mut harness = fried(vec2(1280.0, 720.0));
    press(&mut harness, Key::X);
    let at = harness.state().shown_on_screen(WINDOW).expect("in view");
    harness.hover_at(at);
    let units = ["°C", "°C", "% of the raw water", "highest", "browning", "log₁₀", "% fat"];
    for (key, unit) in KEYS.into_iter().zip(units) {
        press(&mut harness, key);
        harness.get_by_label_contains("here: ");
        let label = harness.get_by_label_contains("here: ").accesskit_node().value().unwrap_or_default();
        assert!(label.contains(unit), "{label} without {unit}");
    }
    save(&mut harness, "read-out");
    // The read-out shows the value of the core.
    let app = harness.state();
    let piece = app.session().shown_piece().expect("steak");
    let point = app.seen_point(at, WINDOW).expect("on the steak");
    let share: f64 = point.shares.0.iter().map(|(_, w)| w).sum();
    assert!((share - 1.0).abs() < 1e-5, "{share}");
    let told = point.shares.read(|node| piece.state.temperature[node]);
    let [x, y] = [0, 1].map(|k| point.shares.read(|node| piece.model.mesh().position(node)[k]));
    let z = if piece.upside_down() { 0.0 } else { piece.model.height_above([x, y]).expect("inside") * 0.999_999 };
    let truth = piece.model.at(&piece.state.temperature, [x, y, z]).expect("inside");
    assert!((told - truth).abs() < 0.5, "{told} in the window, {truth} in the core");
}

#[test]
fn a_probe_is_placed_named_followed_moved_and_taken_out() {
    let mut harness = fried(vec2(1280.0, 720.0));
    let face = harness.state().cut_handle_on_screen(WINDOW).expect("cut")[0] + vec2(-22.0, 44.0);
    harness.hover_at(face);
    steps(&mut harness, 2);
    press(&mut harness, Key::P);
    let probe = harness.state().session().probes.all().first().expect("a probe").clone();
    assert_eq!((probe.number, probe.name.as_str()), (1, "Probe 1"));
    let [point, number] = harness.state().probe_on_screen(1, WINDOW).expect("in view");
    assert!((point - face).length() < 4.0, "it sits where the pointer was: {point:?} {face:?}");
    let upper = harness.state().shown_on_screen(WINDOW).expect("in view") + vec2(-50.0, -30.0);
    harness.hover_at(upper);
    steps(&mut harness, 2);
    press(&mut harness, Key::P);
    assert_eq!(harness.state().session().probes.all().len(), 2);
    cook_on(&mut harness, 60.0);
    save(&mut harness, "probes");
    let series = &harness.state().session().probes.all()[0].series;
    assert!(series.len() > 55 && series.windows(2).all(|w| w[1][0] - w[0][0] > 0.9), "{}", series.len());
    // Named in the panel.
    harness.get_by_label_contains("2 · ").click();
    steps(&mut harness, 2);
    harness.get_by_label("Name of probe 2").focus();
    steps(&mut harness, 2);
    harness.get_by_label("Name of probe 2").type_text(" edge");
    steps(&mut harness, 2);
    assert_eq!(harness.state().session().probes.all()[1].name, "Probe 2 edge");
    // Moved by its number: another point of the same piece, and a new series.
    let before = harness.state().session().probes.all()[0].shares.clone();
    drag(&mut harness, number, number + vec2(-14.0, -12.0));
    let moved = &harness.state().session().probes.all()[0];
    assert!(moved.shares != before && moved.series.len() < 55, "{}", moved.series.len());
    harness.get_by_label("Remove").click_accesskit();
    steps(&mut harness, 2);
    assert_eq!(harness.state().session().probes.all().len(), 1);
    press(&mut harness, Key::R);
    steps(&mut harness, 2);
    assert!(harness.state().session().probes.all().is_empty(), "with the piece its probes are gone");
}

/// Lets time pass although time in the window is stopped.
fn cook_on(harness: &mut Harness<'static, SauteApp>, seconds: f64) {
    harness.state_mut().session_mut().set_paused(false);
    cook(harness, seconds);
    harness.state_mut().session_mut().set_paused(true);
    steps(harness, 2);
}

#[test]
fn six_probes_are_the_most_and_the_seventh_says_so() {
    let mut harness = fried(vec2(1280.0, 720.0));
    press(&mut harness, Key::X);
    let middle = harness.state().shown_on_screen(WINDOW).expect("in view");
    for k in 0..7u8 {
        harness.hover_at(middle + vec2(f32::from(k) * 9.0 - 27.0, -10.0));
        steps(&mut harness, 2);
        press(&mut harness, Key::P);
    }
    assert_eq!(harness.state().session().probes.all().len(), 6);
    harness.get_by_label_contains("All 6 probes are in use");
    save(&mut harness, "six-probes");
}

#[test]
fn a_probe_is_placed_without_a_keyboard() {
    let mut harness = fried(vec2(390.0, 844.0));
    harness.get_by_label("Inside").click();
    steps(&mut harness, 4);
    harness.get_by_label("+ Probe").click_accesskit();
    steps(&mut harness, 2);
    let phone = Rect::from_min_size(pos2(0.0, 0.0), vec2(390.0, 844.0));
    let at = harness.state().shown_on_screen(phone).expect("in view") + vec2(-14.0, -4.0);
    let down = upside_down(&harness);
    click(&mut harness, at);
    assert_eq!(harness.state().session().probes.all().len(), 1);
    assert_eq!(upside_down(&harness), down, "that click does nothing else");
    cook_on(&mut harness, 20.0);
    save(&mut harness, "phone-probe");
}

#[test]
fn the_curves_tell_values_and_events_under_the_pointer() {
    let mut harness = fried(vec2(1280.0, 720.0));
    press(&mut harness, Key::G);
    let plot = harness.get_by_label_contains("Curves of pan").rect();
    // The flip at 200 s: find it from the time axis, 0 to a little over 240 s.
    for k in 0..40u8 {
        harness.hover_at(pos2(plot.left() + plot.width() * (0.6 + 0.01 * f32::from(k)), plot.center().y));
        steps(&mut harness, 2);
        if harness.query_by_label("flip").is_some() {
            break;
        }
    }
    steps(&mut harness, 14);
    save(&mut harness, "curves");
    harness.get_by_label_contains("3:1");
    harness.get_by_label("flip");
    let pan = harness.get_by_label_contains("pan 2");
    assert!(pan.accesskit_node().value().unwrap_or_default().contains("°C"));
}

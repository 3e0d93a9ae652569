//! Promise: how the window looks and reads is chosen on one card, by mouse or by keys, and is remembered.

use egui::{Key, Modifiers, Rect, accesskit::Role, pos2, vec2};
use egui_kittest::{
    Harness,
    kittest::{NodeT, Queryable},
};
use saute_controls::settings::Settings;
use saute_controls::settings::interface_size::InterfaceSize;
use saute_controls::settings::quality_choice::QualityChoice;
use saute_controls::settings::theme::Theme;
use saute_scene::light::room_light::RoomLight;
use saute_scene::light::white_balance::WhiteBalance;
use saute_scene::quality::Quality;
use saute_window::SauteApp;
use saute_window::ui::layout::Layout;
use saute_words::language::Language;

use crate::harness::{cook, press, save, steps, window};

const SIZES: [(egui::Vec2, &str); 2] = [(vec2(1280.0, 720.0), "wide"), (vec2(390.0, 844.0), "phone")];

fn opened(size: egui::Vec2) -> Harness<'static, SauteApp> {
    let mut harness = window(size);
    harness.get_by_label("Settings").click();
    steps(&mut harness, 3);
    assert!(harness.state().settings_are_open());
    harness
}

fn choose(harness: &mut Harness<'static, SauteApp>, choice: &str) {
    // On a small window the card scrolls.
    harness.get_by_label(choice).scroll_to_me();
    steps(harness, 3);
    harness.get_by_label(choice).click();
    steps(harness, 3);
}

#[test]
fn every_setting_is_chosen_on_the_card() {
    for (size, _) in SIZES {
        let mut harness = opened(size);
        let settings = |h: &Harness<'static, SauteApp>| h.state().settings().clone();
        for (choice, theme) in [("As the system", Theme::System), ("Light", Theme::Light), ("Dark", Theme::Dark)] {
            choose(&mut harness, &format!("Panels: {choice}"));
            assert_eq!(settings(&harness).theme, theme);
        }
        for (choice, white) in ["As shot", "Neutral", "Cool", "Warm"].into_iter().zip(WhiteBalance::ALL) {
            choose(&mut harness, &format!("White balance: {choice}"));
            assert_eq!(settings(&harness).white_balance, white);
            harness.get_by_label_contains(&format!("{:.0} K", white.appears_k()));
        }
        for (choice, light) in ["Evening", "Daylight"].into_iter().zip([RoomLight::Evening, RoomLight::Daylight]) {
            choose(&mut harness, &format!("Light: {choice}"));
            assert_eq!(settings(&harness).light, light);
        }
        for (choice, quality) in ["Automatic", "Quick", "Smooth", "Best"].into_iter().zip(QualityChoice::ALL) {
            choose(&mut harness, &format!("Picture: {choice}"));
            assert_eq!(settings(&harness).quality, quality);
        }
        choose(&mut harness, "Temperature: °F");
        assert!(settings(&harness).fahrenheit);
        choose(&mut harness, "Temperature: °C");
        assert!(!settings(&harness).fahrenheit);
        for size in InterfaceSize::ALL {
            choose(&mut harness, &format!("Size: {:.0} %", 100.0 * size.factor()));
            assert_eq!(settings(&harness).size, size);
        }
        for (choice, less) in [("Reduced", true), ("Gliding", false)] {
            choose(&mut harness, &format!("Movement: {choice}"));
            assert_eq!(saute_window::ui::display::moves_less(&settings(&harness)), less);
        }
        choose(&mut harness, "Language: 日本語");
        assert_eq!(settings(&harness).language, crate::harness::japanese());
        choose(&mut harness, "言語: EN");
        assert_eq!(settings(&harness).language, Language::ENGLISH);
        choose(&mut harness, "Done");
        assert!(!harness.state().settings_are_open());
    }
}

#[test]
fn card_choices_and_size_are_reached_with_keys() {
    let mut harness = window(SIZES[0].0);
    press(&mut harness, Key::F2);
    assert!(harness.state().settings_are_open());
    let wanted = "Panels: Light";
    let focused = |h: &Harness<'static, SauteApp>| h.get_by_label(wanted).is_focused();
    for _ in 0..40 {
        if focused(&harness) {
            break;
        }
        press(&mut harness, Key::Tab);
    }
    assert!(focused(&harness), "Tab never reaches \"{wanted}\"");
    press(&mut harness, Key::Space);
    assert_eq!(harness.state().settings().theme, Theme::Light);
    assert!(!harness.state().session().paused, "the key was the card's");
    press(&mut harness, Key::Escape);
    assert!(!harness.state().settings_are_open());
    control_with_plus_and_minus_changes_the_size(&mut harness);
    a_key_shows_it_to_a_class(&mut harness);
}

/// Choices are within the window and on no other one.
#[track_caller]
fn choices_have_room(harness: &Harness<'static, SauteApp>, size: egui::Vec2) {
    let points = Rect::from_min_size(pos2(0.0, 0.0), size / harness.ctx.zoom_factor());
    let named = |label: Option<String>| label.is_some_and(|label| label.contains(": "));
    let nodes = harness.root().children_recursive().filter(|n| n.accesskit_node().role() == Role::RadioButton);
    let radios = nodes.filter(|n| named(n.accesskit_node().label()));
    let rects: Vec<Rect> = radios.map(|n| n.rect()).collect();
    assert_eq!(rects.len(), 24);
    for (i, rect) in rects.iter().enumerate() {
        assert!(points.contains_rect(*rect), "{rect:?} in {points:?}");
        assert!(rects[i + 1..].iter().all(|other| !rect.shrink(0.5).intersects(other.shrink(0.5))), "{rect:?}");
    }
}

#[test]
fn the_card_has_room_in_both_themes_and_languages() {
    for (size, name) in SIZES {
        for (theme, code) in [("Dark", "dark"), ("Light", "light")] {
            let mut harness = opened(size);
            choose(&mut harness, &format!("Panels: {theme}"));
            choices_have_room(&harness, size);
            save(&mut harness, &format!("settings-{name}-{code}"));
            harness.state_mut().set_language(crate::harness::japanese());
            steps(&mut harness, 3);
            choices_have_room(&harness, size);
            save(&mut harness, &format!("settings-{name}-{code}-ja"));
        }
    }
}

#[test]
fn the_light_theme_shows_everything_that_the_dark_one_does() {
    for (size, name) in SIZES {
        let mut harness = opened(size);
        choose(&mut harness, "Panels: Light");
        choose(&mut harness, "Done");
        assert!(!harness.ctx.global_style().visuals.dark_mode);
        save(&mut harness, &format!("light-{name}-start"));
        harness.state_mut().session_mut().command(&saute_kitchen::Command::Hob(1100.0)).expect("hob");
        cook(&mut harness, 90.0);
        press(&mut harness, Key::A);
        cook(&mut harness, 90.0);
        press(&mut harness, Key::F);
        cook(&mut harness, 30.0);
        press(&mut harness, Key::Num4);
        press(&mut harness, Key::X);
        press(&mut harness, Key::B);
        steps(&mut harness, 12);
        save(&mut harness, &format!("light-{name}-doneness"));
        press(&mut harness, Key::Num2);
        press(&mut harness, Key::N);
        steps(&mut harness, 12);
        save(&mut harness, &format!("light-{name}-temperature"));
        press(&mut harness, Key::F1);
        save(&mut harness, &format!("light-{name}-help"));
    }
}

/// The last view's chip is in its panel, and the drawer's last tab beside the gear.
#[track_caller]
fn chips_have_room(harness: &Harness<'static, SauteApp>, size: egui::Vec2) {
    let whole = Rect::from_min_size(pos2(0.0, 0.0), size / harness.ctx.zoom_factor());
    let layout = Layout::new(whole, harness.state().settings());
    let rect = |label| harness.get_by_label(label).rect();
    for last in ["Split", "Sound"] {
        assert!(layout.top.contains_rect(rect(last)), "{:?} in {:?}", rect(last), layout.top);
    }
    assert!(rect("Pieces").right() < rect("Settings").left(), "{:?} {:?}", rect("Pieces"), rect("Settings"));
}

#[test]
fn the_interface_grows_as_far_as_the_window_has_room() {
    for ((size, name), most) in SIZES.into_iter().zip([1.5, 1.0]) {
        let mut harness = opened(size);
        for choice in ["125", "150"] {
            choose(&mut harness, &format!("Size: {choice} %"));
            choices_have_room(&harness, size);
            save(&mut harness, &format!("size-{name}-{choice}-card"));
            press(&mut harness, Key::Escape);
            save(&mut harness, &format!("size-{name}-{choice}"));
            chips_have_room(&harness, size);
            press(&mut harness, Key::F2);
        }
        assert!((harness.ctx.zoom_factor() - most).abs() < 0.01, "{}", harness.ctx.zoom_factor());
        let whole = Rect::from_min_size(pos2(0.0, 0.0), size / harness.ctx.zoom_factor());
        assert!(Layout::new(whole, harness.state().settings()).narrow);
    }
}

fn control_with_plus_and_minus_changes_the_size(harness: &mut Harness<'static, SauteApp>) {
    let size = |h: &Harness<'static, SauteApp>| h.state().settings().size;
    for (key, expected) in [
        (Key::Plus, InterfaceSize::Large),
        (Key::Plus, InterfaceSize::Largest),
        (Key::Plus, InterfaceSize::Largest),
        (Key::Minus, InterfaceSize::Large),
        (Key::Num0, InterfaceSize::Usual),
    ] {
        harness.key_press_modifiers(Modifiers::COMMAND, key);
        steps(harness, 2);
        assert_eq!(size(harness), expected);
    }
}

/// Large and without panels, and back to the size that was chosen; the key of the panels brings them back, too.
fn a_key_shows_it_to_a_class(harness: &mut Harness<'static, SauteApp>) {
    let chosen = harness.ctx.zoom_factor();
    for (key, projects) in [(Key::F10, true), (Key::F10, false), (Key::F10, true), (Key::H, false)] {
        press(harness, key);
        save(harness, if projects { "projector" } else { "no-projector" });
        let expected = if projects { InterfaceSize::Largest.factor() } else { chosen };
        assert!((harness.ctx.zoom_factor() - expected).abs() < 0.01, "{}", harness.ctx.zoom_factor());
        let settings = harness.state().settings();
        assert_eq!((settings.hides_panels(), settings.size), (projects, InterfaceSize::Usual));
        assert_eq!(harness.query_by_label("Settings").is_none(), projects);
        assert!(harness.query_by_label_contains("As advised").is_some(), "the line says what to do");
    }
}

#[test]
fn the_best_quality_draws_every_pixel_and_the_scene_is_never_drawn_small() {
    let mut harness = opened(SIZES[0].0);
    choose(&mut harness, "Picture: Best");
    assert_eq!(harness.state().quality(), Quality::Best);
    assert_eq!(harness.state().scene_size(), [1280, 720]);
    choose(&mut harness, "Picture: Quick");
    let [w, h] = harness.state().scene_size();
    assert!(w >= 960 && h >= 540, "{w} {h}");
}

#[test]
fn settings_are_remembered_and_old_ones_are_still_read() {
    let chosen = Settings {
        theme: Theme::Light,
        white_balance: WhiteBalance::Warm,
        quality: QualityChoice::Always(Quality::Best),
        size: InterfaceSize::Largest,
        ..Settings::default()
    };
    let text = serde_json::to_string(&chosen).expect("is written");
    assert_eq!(serde_json::from_str::<Settings>(&text).expect("is read"), chosen);
    let old = serde_json::from_str::<Settings>("{\"fahrenheit\":true}").expect("is read");
    assert!(old.fahrenheit && old.theme == Theme::Dark && old.quality == QualityChoice::Automatic);
}

/// Who asks for less motion sees the eye, the food and the panels where they go, not on their way.
#[test]
fn with_less_motion_nothing_glides() {
    let mut harness = opened(SIZES[0].0);
    choose(&mut harness, "Movement: Reduced");
    press(&mut harness, Key::Escape);
    let seen = |h: &Harness<'static, SauteApp>| h.state().on_screen(glam::Vec3::ZERO, crate::harness::WINDOW);
    let steps_until_there = |harness: &mut Harness<'static, SauteApp>, view: &str| {
        harness.get_by_label(view).click();
        steps(harness, 2);
        let soon = seen(harness);
        steps(harness, 24);
        soon == seen(harness)
    };
    assert!(steps_until_there(&mut harness, "Above"), "the eye jumps");
    let steak = |h: &Harness<'static, SauteApp>| h.state().shown_on_screen(crate::harness::WINDOW);
    harness.key_press(Key::Space);
    harness.key_press(Key::A);
    steps(&mut harness, 3);
    let soon = steak(&harness);
    steps(&mut harness, 12);
    assert_eq!(soon, steak(&harness), "the steak is in the pan at once");
    assert_eq!(harness.ctx.global_style().animation_time, 0.0);
    press(&mut harness, Key::F2);
    choose(&mut harness, "Movement: Gliding");
    press(&mut harness, Key::Escape);
    assert!(!steps_until_there(&mut harness, "Front"), "the eye glides");
    assert!(harness.ctx.global_style().animation_time > 0.0);
}

//! The window in Japanese: no English is left, everything has room, no letter lacks its picture.

use egui::{FontId, Key, accesskit::Role, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT, Queryable};
use saute_kitchen::Command;
use saute_window::SauteApp;
use saute_words::language::Language;

use crate::harness::{cook, graphics, press, save, steps, window};

const SIZES: [(egui::Vec2, &str); 2] = [(vec2(1280.0, 720.0), "wide"), (vec2(390.0, 844.0), "phone")];

/// Units, symbols, what is written on keys and pads, abbreviations that Japanese texts use as they are.
const LATIN: [&str; 40] = [
    "W", "g", "mg", "s", "mm", "cm", "C", "F", "log", "AMSA", "USDA", "EN", "toml", "Space", "Esc", "Home", "End",
    "Enter", "Ins", "Del", "Page", "Bksp", "up", "down", "Shift", "Ctrl", "Alt", "WASD", "L", "R", "LT", "RT", "LB",
    "RB", "stick", "D", "pad", "Start", "Select", "F1",
];

fn japanese(size: egui::Vec2) -> Harness<'static, SauteApp> {
    let mut harness = window(size);
    harness.state_mut().set_language(crate::harness::japanese());
    assert_eq!(
        harness.state().settings().language,
        crate::harness::japanese(),
        "needs a Japanese font: fonts-ipafont-gothic"
    );
    steps(&mut harness, 3);
    harness
}

/// Everything that the window gives a screen reader, and so everything that it shows as text.
fn said(harness: &Harness<'static, SauteApp>) -> Vec<String> {
    let nodes: Vec<_> = harness.root().children_recursive().collect();
    let both = |n: &egui_kittest::Node<'_>| [n.accesskit_node().label(), n.accesskit_node().value()];
    nodes.iter().flat_map(both).flatten().collect()
}

#[track_caller]
fn no_english(harness: &Harness<'static, SauteApp>, state: &str) {
    let said = said(harness);
    assert!(said.len() > 5, "{state}: {said:?}");
    for text in said {
        let words = text.split(|c: char| !c.is_ascii_alphabetic()).filter(|w| w.len() > 1 || w.is_empty());
        let english: Vec<&str> = words.filter(|w| !w.is_empty() && !LATIN.contains(w)).collect();
        assert!(english.is_empty(), "{state}: {english:?} in \"{text}\"");
    }
}

/// Buttons stay within the window, and where it is wide left of the panel at the right.
#[track_caller]
fn buttons_have_room(harness: &Harness<'static, SauteApp>, size: egui::Vec2) {
    let buttons = harness.root().children_recursive().filter(|n| n.accesskit_node().role() == Role::Button);
    for button in buttons {
        let rect = button.rect();
        let right = if size.x > 700.0 && rect.top() > 540.0 && rect.left() < 900.0 { 962.0 } else { size.x };
        assert!(rect.left() >= 0.0 && rect.right() <= right, "{:?} {rect:?}", button.accesskit_node().label());
    }
}

#[test]
fn a_cook_in_japanese_shows_no_english() {
    for (size, name) in SIZES {
        let mut harness = japanese(size);
        no_english(&harness, "start");
        buttons_have_room(&harness, size);
        save(&mut harness, &format!("ja-{name}-start"));
        harness.state_mut().session_mut().command(&Command::Hob(1100.0)).expect("hob");
        cook(&mut harness, 60.0);
        press(&mut harness, Key::A);
        cook(&mut harness, 60.0);
        press(&mut harness, Key::F);
        cook(&mut harness, 20.0);
        for key in [Key::Num2, Key::Num3, Key::Num4, Key::Num5, Key::Num6, Key::Num7, Key::X] {
            press(&mut harness, key);
            no_english(&harness, &format!("view {key:?}"));
        }
        press(&mut harness, Key::Num4);
        save(&mut harness, &format!("ja-{name}-doneness"));
        press(&mut harness, Key::D);
        press(&mut harness, Key::O);
        cook(&mut harness, 5.0);
        no_english(&harness, "resting");
        if name == "phone" {
            harness.get_by_label("中身").click();
            steps(&mut harness, 3);
            no_english(&harness, "inside");
            save(&mut harness, "ja-phone-inside");
        }
    }
}

#[test]
fn panels_notices_and_help_in_japanese_show_no_english() {
    for (size, name) in SIZES {
        let mut harness = japanese(size);
        for key in [Key::N, Key::B, Key::U, Key::Num0, Key::T, Key::Z, Key::Num8, Key::F, Key::P, Key::D] {
            press(&mut harness, key);
            no_english(&harness, &format!("{name} {key:?}"));
        }
        press(&mut harness, Key::N);
        save(&mut harness, &format!("ja-{name}-pantry"));
        press(&mut harness, Key::F1);
        no_english(&harness, "help");
        save(&mut harness, &format!("ja-{name}-help"));
        press(&mut harness, Key::F2);
        no_english(&harness, "settings");
    }
}

/// Hints show themselves after half a second under a resting pointer; walked on every button of the window and its
/// panels.
#[test]
fn hints_under_the_pointer_show_no_english() {
    let mut harness = japanese(SIZES[0].0);
    let mut hints = 0;
    for key in [None, Some(Key::N), Some(Key::B)] {
        if let Some(key) = key {
            press(&mut harness, key);
        }
        let buttons = harness.root().children_recursive().filter(|n| n.accesskit_node().role() == Role::Button);
        let centres: Vec<egui::Pos2> = buttons.map(|n| n.rect().center()).collect();
        for at in centres {
            let before = said(&harness).len();
            harness.hover_at(at);
            steps(&mut harness, 14);
            hints += usize::from(said(&harness).len() > before);
            no_english(&harness, &format!("hint at {at:?}"));
            harness.hover_at(egui::pos2(640.0, 330.0));
            steps(&mut harness, 3);
        }
    }
    assert!(hints > 8, "only {hints} hints appeared");
}

#[test]
fn a_recipe_of_ours_plays_in_japanese() {
    let mut harness = japanese(SIZES[0].0);
    let library = saute_kitchen::Library::embedded().expect("embedded data");
    for (id, text) in &library.recipes {
        harness.state_mut().open_recipe(text, id);
        steps(&mut harness, 4);
        press(&mut harness, Key::B);
        no_english(&harness, id);
        press(&mut harness, Key::B);
    }
    save(&mut harness, "ja-wide-recipe");
}

#[test]
fn no_letter_lacks_its_picture() {
    let harness = japanese(SIZES[0].0);
    let font = FontId::proportional(15.0);
    for l in Language::all() {
        for letter in l.file().chars().filter(|c| !c.is_control()) {
            assert!(harness.ctx.fonts_mut(|f| f.has_glyph(&font, letter)), "{letter} ({:x})", letter as u32);
        }
    }
}

#[test]
fn the_first_start_shows_three_steps_once_and_the_help_calls_them_back() {
    for (size, name) in SIZES {
        for language in Language::all() {
            let mut harness = first_start(size, language);
            let code = language.code();
            assert!(harness.state().first_steps_are_open());
            for key in ["first.set_out", "first.heat", "first.watch"] {
                harness.get_by_label_contains(language.text(key));
            }
            if language == crate::harness::japanese() {
                no_english(&harness, "first steps");
            }
            buttons_have_room(&harness, size);
            save(&mut harness, &format!("first-{code}-{name}"));
            harness.get_by_label(language.text("first.begin")).click();
            steps(&mut harness, 3);
            assert!(!harness.state().first_steps_are_open() && harness.state().settings().introduced);
            few_controls_and_the_way_to_all(&mut harness, language);
            buttons_have_room(&harness, size);
            save(&mut harness, &format!("few-{code}-{name}"));
            press(&mut harness, Key::F1);
            harness.get_by_label(language.text("help.first_steps")).click();
            steps(&mut harness, 3);
            assert!(harness.state().first_steps_are_open() && !harness.state().help_is_open());
        }
    }
    assert!(!window(SIZES[0].0).state().first_steps_are_open());
}

/// A first cook has the hob, three things for hands, undo and time; the rest is behind one button.
fn few_controls_and_the_way_to_all(harness: &mut Harness<'static, SauteApp>, language: Language) {
    for key in ["hob.food_in", "hob.flip", "hob.take_out", "strip.undo", "hob.pause", "top.all"] {
        assert!(harness.query_all_by_label_contains(language.text(key)).next().is_some(), "{key}");
    }
    for key in ["pour.lid", "hob.step", "inside.more", "drawer.inside", "top.pieces"] {
        assert!(harness.query_by_label(language.text(key)).is_none(), "{key}");
    }
    assert!(harness.query_all_by_label_contains("1100 W").next().is_some(), "the line asks for the hob");
    harness.get_by_label(language.text("top.all")).click();
    steps(harness, 3);
    assert!(!harness.state().settings().few && harness.query_by_label(language.text("hob.step")).is_some());
    press(harness, Key::F6);
    assert!(harness.state().settings().few);
}

/// A window that remembers nothing yet.
fn first_start(size: egui::Vec2, language: Language) -> Harness<'static, SauteApp> {
    let mut harness =
        Harness::builder().with_size(size).with_step_dt(0.05).wgpu_setup(graphics()).build_eframe(move |cc| {
            let graphics = cc.wgpu_render_state.as_ref();
            let code = language.code();
            let stored = format!("{{\"language\":\"{code}\"}}");
            SauteApp::start(&cc.egui_ctx, graphics, Some(stored), Default::default()).expect("starts")
        });
    steps(&mut harness, 3);
    harness
}

#[test]
fn the_language_is_chosen_in_the_settings() {
    let mut harness = window(SIZES[0].0);
    harness.get_by_label("Settings").click();
    steps(&mut harness, 3);
    harness.get_by_label("Language: 日本語").scroll_to_me();
    steps(&mut harness, 3);
    harness.get_by_label("Language: 日本語").click();
    steps(&mut harness, 3);
    assert_eq!(harness.state().settings().language, crate::harness::japanese());
    harness.get_by_label("閉じる");
}

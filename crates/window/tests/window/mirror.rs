//! Promise: the half mirror has its own window, which shows the food on black or the calibration's pattern; its
//! marks are moved by mouse and keys, and its choices are on a card.

use egui::{Event, Key, Modifiers, Pos2, Ui, pos2, vec2};
use egui_kittest::{Harness, kittest::Queryable};
use glam::DVec2;
use saute_mirror::rig_file::shipped;
use saute_mirror::settings::MirrorSettings;
use saute_mirror::stereo::Stereo;
use saute_scene::input::SceneInput;
use saute_scene::quality::Quality;
use saute_scene::sample::{Doneness, steak_in_pan};
use saute_window::mirror::callback::MirrorCallback;
use saute_window::mirror::view::MirrorView;
use saute_words::language::Language;

use crate::harness::{graphics, press, save, steps, window};

/// The mirror's window alone.
struct MirrorWindow {
    view: MirrorView,
    settings: MirrorSettings,
    scene: SceneInput,
}

impl eframe::App for MirrorWindow {
    fn ui(&mut self, ui: &mut Ui, _frame: &mut eframe::Frame) {
        self.view.take_keys(ui);
        self.view.show(ui, &mut self.settings, Some(&self.scene), Quality::Smooth, Language::ENGLISH);
    }
}

const SIZE: DVec2 = DVec2::new(960.0, 540.0);

fn mirror_window() -> Harness<'static, MirrorWindow> {
    let mut harness =
        Harness::builder().with_size(vec2(960.0, 540.0)).with_step_dt(0.05).wgpu_setup(graphics()).build_eframe(|cc| {
            MirrorCallback::install(cc.wgpu_render_state.as_ref().expect("graphics"));
            let mut view = MirrorView::default();
            view.open = true;
            MirrorWindow { view, settings: MirrorSettings::default(), scene: steak_in_pan(Doneness::Browned) }
        });
    harness.step();
    harness
}

fn keep(harness: &mut Harness<'static, MirrorWindow>, name: &str) -> image::RgbaImage {
    let picture = harness.render().expect("renders");
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("window");
    std::fs::create_dir_all(&folder).expect("folder");
    picture.save(folder.join(format!("{name}.png"))).expect("saves");
    picture
}

fn key(harness: &mut Harness<'static, MirrorWindow>, key: Key, modifiers: Modifiers) {
    harness.key_press_modifiers(modifiers, key);
    (0..2).for_each(|_| harness.step());
}

/// Where a mark is shown.
fn mark(harness: &Harness<'static, MirrorWindow>, mark: usize) -> DVec2 {
    let rig = shipped("flat-screen").expect("is there").expect("is read");
    harness.state().settings.calibration().pixels(&rig, SIZE).expect("is shown")[mark]
}

#[test]
fn the_mirror_window_shows_food_on_black_and_nothing_else() {
    let mut harness = mirror_window();
    let picture = keep(&mut harness, "mirror-picture");
    for (x, y) in [(2, 2), (957, 2), (2, 537), (957, 537)] {
        assert_eq!(picture.get_pixel(x, y).0[..3], [0; 3], "{x} {y}");
    }
    let lit = picture.pixels().filter(|p| p.0[..3].iter().any(|v| *v > 30)).count();
    assert!(lit > 5000 && lit < 960 * 540 / 3, "{lit}");
    for (stereo, name) in [(Stereo::Anaglyph, "mirror-anaglyph"), (Stereo::SideBySide, "mirror-side-by-side")] {
        harness.state_mut().settings.stereo = stereo;
        harness.step();
        assert!(keep(&mut harness, name) != picture);
    }
}

#[test]
fn arrow_keys_move_the_chosen_mark_by_a_pixel_and_with_shift_by_a_tenth_as_the_eye_sees_it() {
    let mut harness = mirror_window();
    key(&mut harness, Key::F10, Modifiers::NONE);
    assert!(harness.state().view.calibrating);
    keep(&mut harness, "mirror-pattern");
    key(&mut harness, Key::Num3, Modifiers::NONE);
    let before = mark(&harness, 2);
    key(&mut harness, Key::ArrowRight, Modifiers::NONE);
    let after = mark(&harness, 2);
    // What the eye sees at its right is at the left of a panel before a mirror.
    assert!((after - before).distance(DVec2::new(-1.0, 0.0)) < 0.02, "{before} {after}");
    key(&mut harness, Key::ArrowDown, Modifiers::SHIFT);
    let finer = mark(&harness, 2);
    assert!((finer - after).distance(DVec2::new(0.0, 0.1)) < 0.02, "{after} {finer}");
    key(&mut harness, Key::Tab, Modifiers::NONE);
    assert_eq!(harness.state().view.aim.chosen, 3);
    key(&mut harness, Key::Backspace, Modifiers::NONE);
    assert!(mark(&harness, 2).distance(before) < 1e-9, "reset");
}

#[test]
fn the_mouse_drags_marks_and_what_it_finds_is_kept_for_the_projector() {
    let mut harness = mirror_window();
    key(&mut harness, Key::F10, Modifiers::NONE);
    let from = mark(&harness, 1);
    let at = |p: DVec2| pos2(p.x as f32, p.y as f32);
    let by = DVec2::new(23.0, 14.0);
    drag(&mut harness, at(from) + vec2(3.0, -2.0), at(from + by) + vec2(3.0, -2.0));
    assert!(mark(&harness, 1).distance(from + by) < 0.01, "{} {}", mark(&harness, 1), from + by);
    assert_eq!(harness.state().view.aim.chosen, 1);
    keep(&mut harness, "mirror-pattern-dragged");
    harness.state_mut().settings.projector = "ceiling".to_owned();
    assert!(mark(&harness, 1).distance(from) < 1e-9);
    harness.state_mut().settings.projector = "1".to_owned();
    assert!(mark(&harness, 1).distance(from + by) < 0.01);
}

fn drag(harness: &mut Harness<'static, MirrorWindow>, from: Pos2, to: Pos2) {
    harness.hover_at(from);
    harness.step();
    harness.drag_at(from);
    harness.step();
    for k in 1..=8u8 {
        harness.hover_at(from + (to - from) * (f32::from(k) / 8.0));
        harness.step();
    }
    harness.drop_at(to);
    harness.step();
}

#[test]
fn f11_fills_the_screen_and_esc_closes() {
    let mut harness = mirror_window();
    key(&mut harness, Key::F11, Modifiers::NONE);
    assert!(harness.state().view.full);
    key(&mut harness, Key::Escape, Modifiers::NONE);
    assert!(!harness.state().view.open && !harness.state().view.full);
}

#[test]
fn a_key_opens_the_mirror_beside_the_operators_panels() {
    let mut harness = window(vec2(1280.0, 720.0));
    press(&mut harness, Key::F9);
    assert!(harness.state().mirror().open);
    harness.get_by_label("Picture for the half mirror");
    harness.get_by_label("Settings");
    save(&mut harness, "mirror-beside");
    press(&mut harness, Key::F9);
    assert!(!harness.state().mirror().open);
}

#[test]
fn the_mirrors_choices_stand_on_a_card_in_both_languages() {
    for (size, name) in [(vec2(1280.0, 720.0), "wide"), (vec2(390.0, 844.0), "phone")] {
        let mut harness = window(size);
        // A card is laid out again until it has found its size.
        harness.get_by_label("Settings").click();
        steps(&mut harness, 8);
        harness.get_by_label("Half mirror…").click();
        steps(&mut harness, 8);
        for (choice, way) in ["Off", "Red and cyan", "Side by side"].into_iter().zip(Stereo::ALL) {
            harness.get_by_label(&format!("Stereo: {choice}")).click();
            steps(&mut harness, 3);
            assert_eq!(harness.state().settings().mirror.stereo, way);
        }
        for (choice, rig) in [("projector", "projector"), ("flat-screen", "flat-screen")] {
            harness.get_by_label(&format!("Rig: {choice}")).click();
            steps(&mut harness, 3);
            assert_eq!(harness.state().settings().mirror.rig, rig);
        }
        harness.get_by_label("Pan: Drawn").click();
        steps(&mut harness, 3);
        assert!(harness.state().settings().mirror.pan_shown);
        save(&mut harness, &format!("mirror-card-{name}"));
        harness.state_mut().set_language(crate::harness::japanese());
        steps(&mut harness, 3);
        save(&mut harness, &format!("mirror-card-{name}-ja"));
        harness.input_mut().events.push(Event::PointerGone);
        press(&mut harness, Key::Escape);
    }
}

//! Promise: nothing that was done is lost: undo, redo, a strip of time, and starting over that can be undone.

use egui::accesskit::Role;
use egui::{Event, Key, Modifiers, Pos2, pos2};
use egui_kittest::{Harness, kittest::Queryable};
use saute_controls::act::{Act, AppAct, CookAct, TimeAct};
use saute_controls::settings::theme::Theme;
use saute_window::{DesktopOptions, SauteApp, Start};
use saute_words::act_words::act_words;
use saute_words::language::Language;

use crate::harness::{click, cook, drag, press, save, steps, window, window_with};

const WIDE: egui::Vec2 = egui::vec2(1280.0, 720.0);
const PHONE: egui::Vec2 = egui::vec2(390.0, 844.0);

fn chord(harness: &mut Harness<'static, SauteApp>, modifiers: Modifiers, key: Key) {
    let event = |pressed| Event::Key { key, physical_key: None, pressed, repeat: false, modifiers };
    harness.event(event(true));
    harness.event(event(false));
    steps(harness, 3);
    while harness.state().session().is_travelling() {
        harness.step();
    }
    steps(harness, 2);
}

fn undo(harness: &mut Harness<'static, SauteApp>) {
    chord(harness, Modifiers::COMMAND, Key::Z);
}

fn hash(harness: &Harness<'static, SauteApp>) -> u64 {
    harness.state().session().kitchen.state_hash()
}

fn time_s(harness: &Harness<'static, SauteApp>) -> f64 {
    harness.state().session().kitchen.time_s()
}

/// A steak that was put in, turned over after a while, and fried on; time is stopped.
fn fried(size: egui::Vec2) -> Harness<'static, SauteApp> {
    let mut harness = window(size);
    harness.state_mut().session_mut().set_paused(true);
    press(&mut harness, Key::E);
    press(&mut harness, Key::E);
    cook(&mut harness, 40.0);
    press(&mut harness, Key::A);
    cook(&mut harness, 60.0);
    press(&mut harness, Key::F);
    cook(&mut harness, 50.0);
    harness
}

/// Room for a time at either end of the strip.
const END: f32 = 40.0;

/// A place on the strip by a share of its length.
fn on_strip(harness: &Harness<'static, SauteApp>, share: f32) -> Pos2 {
    let rect = harness.get_by_role_and_label(Role::Slider, "Time of the cook").rect();
    pos2(rect.left() + END + share * (rect.width() - 2.0 * END), rect.center().y)
}

/// Share of the strip for a time, with five minutes in all.
fn share(seconds: f32) -> f32 {
    seconds / 300.0
}

#[test]
fn ctrl_z_undoes_and_ctrl_y_or_ctrl_shift_z_redoes() {
    let mut harness = fried(WIDE);
    let end = hash(&harness);
    undo(&mut harness);
    assert!((time_s(&harness) - 100.0).abs() < 1.0 && harness.state().session().paused);
    assert!(harness.query_by_label_contains("Undone: flip. It is 1:40 again").is_some());
    save(&mut harness, "time-undone");
    undo(&mut harness);
    assert!((time_s(&harness) - 40.0).abs() < 1.0);
    chord(&mut harness, Modifiers::COMMAND, Key::Y);
    chord(&mut harness, Modifiers::COMMAND | Modifiers::SHIFT, Key::Z);
    assert_eq!(hash(&harness), end);
    // The buttons do the same.
    harness.get_by_label("Undo").click();
    steps(&mut harness, 4);
    harness.state_mut().session_mut().finish_travel();
    assert!((time_s(&harness) - 100.0).abs() < 1.0);
    harness.get_by_label("Redo").click();
    steps(&mut harness, 4);
    harness.state_mut().session_mut().finish_travel();
    assert_eq!(hash(&harness), end);
}

#[test]
fn the_strip_is_dragged_through_time_and_back() {
    let mut harness = fried(WIDE);
    let end = hash(&harness);
    let (from, to) = (on_strip(&harness, share(150.0)), on_strip(&harness, share(60.0)));
    drag(&mut harness, from, to);
    harness.state_mut().session_mut().finish_travel();
    steps(&mut harness, 3);
    assert!((time_s(&harness) - 60.0).abs() < 2.0, "{}", time_s(&harness));
    assert!(harness.state().session().end_s() > 149.0);
    save(&mut harness, "time-scrubbed");
    let (from, to) = (on_strip(&harness, share(60.0)), on_strip(&harness, 1.0));
    drag(&mut harness, from, to);
    harness.state_mut().session_mut().finish_travel();
    assert_eq!(hash(&harness), end);
    // A click on a mark goes to it; arrow keys turn time by a second and to the marks.
    let flip = on_strip(&harness, share(101.0));
    click(&mut harness, flip);
    harness.state_mut().session_mut().finish_travel();
    assert!((time_s(&harness) - 100.0).abs() < 1.0, "{}", time_s(&harness));
    let at = time_s(&harness);
    for (key, expected) in [(Key::ArrowLeft, at - 1.0), (Key::ArrowRight, at), (Key::ArrowDown, 40.0)] {
        harness.get_by_role_and_label(Role::Slider, "Time of the cook").focus();
        steps(&mut harness, 2);
        press(&mut harness, key);
        harness.state_mut().session_mut().finish_travel();
        assert!((time_s(&harness) - expected).abs() < 0.8, "{key:?} {} {expected}", time_s(&harness));
    }
}

#[test]
fn starting_over_is_undone() {
    let mut harness = fried(WIDE);
    let end = hash(&harness);
    press(&mut harness, Key::R);
    assert!(time_s(&harness) < 1.0);
    undo(&mut harness);
    assert_eq!(hash(&harness), end);
    assert!(harness.query_by_label_contains("The cook from before is back.").is_some());
}

#[test]
fn another_way_is_gone_and_the_first_one_is_kept() {
    let mut harness = fried(WIDE);
    let end = hash(&harness);
    undo(&mut harness);
    press(&mut harness, Key::Q);
    cook(&mut harness, 50.0);
    harness.get_by_label("Other ways: 1").click();
    steps(&mut harness, 4);
    save(&mut harness, "time-ways");
    harness.get_by_label("flip at 1:40").click();
    steps(&mut harness, 4);
    harness.state_mut().session_mut().finish_travel();
    // It is at the time of the way that was left, and goes on to its own end.
    let session = harness.state_mut().session_mut();
    session.scrub(1e9);
    session.finish_travel();
    assert_eq!(hash(&harness), end);
}

#[test]
fn the_strip_is_at_hand_on_a_phone_and_on_paper() {
    let mut harness = fried(PHONE);
    save(&mut harness, "phone-time");
    harness.get_by_label("Undo").click();
    steps(&mut harness, 6);
    harness.state_mut().session_mut().finish_travel();
    assert!((time_s(&harness) - 100.0).abs() < 1.0);
    let rect = harness.get_by_role_and_label(Role::Slider, "Time of the cook").rect();
    assert!(rect.width() > 150.0 && rect.height() >= 28.0, "{rect}");
    let set = saute_controls::act::Setting::Theme(Theme::Light);
    let ctx = harness.ctx.clone();
    harness.state_mut().act(Act::App(AppAct::Set(set)), &ctx);
    steps(&mut harness, 4);
    save(&mut harness, "phone-time-light");
    harness.set_size(WIDE);
    steps(&mut harness, 4);
    save(&mut harness, "time-light");
}

#[test]
fn a_window_that_was_killed_goes_on_with_its_cook() {
    let file = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("cook-{}.saute", std::process::id()));
    let mut harness = fried(WIDE);
    harness.state_mut().keep_cook_in(&file);
    steps(&mut harness, 3);
    undo(&mut harness);
    press(&mut harness, Key::Q);
    cook(&mut harness, 20.0);
    std::thread::sleep(std::time::Duration::from_millis(600));
    steps(&mut harness, 2);
    let end = hash(&harness);
    drop(harness);
    let mut harness = window(WIDE);
    harness.state_mut().keep_cook_in(&file);
    steps(&mut harness, 3);
    assert!(harness.query_by_label("It stopped at 2:00. Everything is as it was.").is_some());
    save(&mut harness, "time-unfinished");
    harness.get_by_label("Go on with it").click();
    steps(&mut harness, 4);
    harness.state_mut().session_mut().finish_travel();
    steps(&mut harness, 2);
    assert_eq!(hash(&harness), end);
    assert_eq!(harness.state().session().marks.len(), 4);
    std::fs::remove_file(&file).expect("removes");
}

/// What is done while the exact instant is still computed happens in it, and nothing waits for it.
#[test]
fn what_is_done_while_time_is_turned_waits_for_the_instant() {
    let mut harness = fried(WIDE);
    let ctx = harness.ctx.clone();
    // A copy without keyframes: the way is long.
    let recording = harness.state().session().recording().clone();
    harness.state_mut().session_mut().resume(recording).expect("resumes");
    harness.step();
    assert!(harness.state().session().is_travelling());
    harness.state_mut().act(Act::Cook(CookAct::HobSet(500.0)), &ctx);
    harness.state_mut().act(Act::Cook(CookAct::Out), &ctx);
    assert!(harness.state().session().is_travelling(), "no act goes the way to its end");
    steps(&mut harness, 3);
    assert!(harness.query_by_label_contains("As soon as 2:30 is reached: 500 W, ").is_some());
    save(&mut harness, "time-waiting");
    // Undo takes back what waits.
    harness.state_mut().act(Act::Time(TimeAct::Undo), &ctx);
    while harness.state().session().is_travelling() {
        harness.step();
    }
    steps(&mut harness, 3);
    let session = harness.state().session();
    assert_eq!((session.kitchen.hob_w(), session.marks.len()), (500.0, 5));
    assert!((session.marks[4].time_s - 150.0).abs() < 1.0 && session.kitchen.pieces()[0].in_pan());
}

#[test]
fn a_cook_is_saved_as_a_whole_or_not_at_all() {
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("saved-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("folder");
    let mut harness = fried(WIDE);
    let end = hash(&harness);
    harness.get_by_label("File").click();
    steps(&mut harness, 4);
    assert!(harness.query_by_label("Save this cook…").is_some());
    press(&mut harness, Key::Escape);
    // What is ahead is saved, too.
    undo(&mut harness);
    harness.state_mut().save_export(saute_session::export::Export::Cook, &folder.join("mine"));
    steps(&mut harness, 2);
    assert!(harness.query_by_label_contains("The cook is saved in ").is_some());
    save(&mut harness, "time-saved");
    let file = folder.join("mine.saute");
    let bytes = std::fs::read(&file).expect("is there");
    // A folder that is not there, and one whose name is taken by a file.
    for place in [folder.join("nowhere").join("mine.saute"), file.join("mine.saute")] {
        harness.state_mut().save_export(saute_session::export::Export::Cook, &place);
        steps(&mut harness, 2);
        assert!(harness.query_by_label_contains("The cook could not be saved in ").is_some(), "{}", place.display());
    }
    assert_eq!(std::fs::read(&file).expect("is there"), bytes);
    assert_eq!(std::fs::read_dir(&folder).expect("folder").count(), 1, "nothing half-written is left");
    let opened = saute_recipe::Recording::from_file(&bytes).expect("opens");
    let session = harness.state_mut().session_mut();
    session.resume(opened.recording).expect("resumes");
    session.finish_travel();
    assert_eq!(hash(&harness), end);
    std::fs::remove_dir_all(&folder).expect("removes");
}

/// A system without file dialogs is distinguished from a person who cancels: what is saved goes into the folder of pictures, and no file
/// that is there is written over.
#[test]
fn without_a_file_dialog_a_cook_is_saved_with_the_pictures() {
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("dialogs-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("folder");
    let mut harness = window_with(
        WIDE,
        Start {
            desktop: DesktopOptions { pictures: Some(folder.clone()), ..DesktopOptions::default() },
            ..Start::default()
        },
    );
    for count in 1..=2 {
        harness.state_mut().export_without_dialog(saute_session::export::Export::Cook);
        steps(&mut harness, 2);
        assert!(harness.query_by_label_contains("This system shows no file dialogs: saved in ").is_some());
        assert_eq!(std::fs::read_dir(&folder).expect("folder").count(), count);
    }
    // Both can be opened again: they are listed.
    assert!(harness.state().settings().recent.iter().all(|file| file.is_file()));
    assert_eq!(harness.state().settings().recent.len(), 2);
    std::fs::remove_dir_all(&folder).expect("removes");
}

#[test]
fn food_that_was_added_and_stretches_of_a_hand_have_marks() {
    let mut harness = fried(WIDE);
    let labels = |harness: &Harness<'static, SauteApp>| -> Vec<String> {
        let words = |mark: &saute_session::Mark| act_words(&mark.done, Language::ENGLISH);
        harness.state().session().marks.iter().skip(4).map(words).collect()
    };
    let session = harness.state_mut().session_mut();
    session.add(&Default::default(), 3).expect("adds");
    for stretch in 0..2 {
        for step in 0..20 {
            let pose = saute_kitchen::dynamics::Pose::at(0.002 * f64::from(step), 0.0, 0.0);
            session.command(&saute_kitchen::Command::HoldPan { pose }).expect("holds");
            session.tick().expect("ticks");
        }
        session.command(&saute_kitchen::Command::LetGo).expect("lets go");
        (0..30 * (1 - stretch)).for_each(|_| session.tick().expect("ticks"));
    }
    steps(&mut harness, 3);
    assert_eq!(labels(&harness), ["food added", "moved by hand", "moved by hand"]);
    save(&mut harness, "time-marks");
    // They come back when the cook is played again.
    let recording = harness.state().session().recording().clone();
    let marks = harness.state().session().marks.clone();
    let session = harness.state_mut().session_mut();
    session.resume(recording).expect("resumes");
    session.finish_travel();
    assert_eq!(session.marks, marks);
}

//! Promise: studies and lessons are gone through in the window: cards, ribbon, locks, hidden read-outs, rows and results.

use std::path::Path;
use std::sync::Arc;

use egui::accesskit::Role;
use egui::{Key, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use saute_controls::kept::log_file::study_in_folder;
use saute_kitchen::Library;
use saute_picture::View;
use saute_session::guided::{Guided, LessonStart};
use saute_study::class::{Scenario, shipped};
use saute_study::{LogRow, Pace, Protocol, RowKind, Stage, from_csv};
use saute_window::{DesktopOptions, SauteApp, Start};

use crate::harness::{cook, drawn_words, press, save, steps, window_with};
use crate::sound::Witness;

/// Two short trials, one before and one after the stove, with hidden read-outs in both conditions.
const PROTOCOL: &str = r#"id = "tiny"
title = "A tiny study"
consent = "You will cook twice. Only your code and what you do is kept."
keep_sessions = true
[[condition]]
id = "A"
information = "hidden"
[[phase]]
title = "First"
[phase.simulate]
recipe = "medium"
goal = "study-2013"
trials = 1
speed = 5
max_s = 25
feedback = true
[[phase]]
title = "Stove"
[phase.cook_for_real]
instructions = "Cook the steak at the stove."
goal = "study-2013"
enter = ["core_c", "class"]
[[phase]]
title = "Second"
[phase.simulate]
recipe = "medium"
goal = "study-2013"
trials = 1
speed = 5
max_s = 600
[[phase]]
title = "Questions"
[phase.questionnaire]
[[phase.questionnaire.item]]
id = "fun"
text = "Was it fun?"
answer = "likert"
"#;

/// A machine that sustains the speed that is set.
const HOLDS: Pace = Pace { set: 5.0, held_median: 5.0, behind_s: 0.0 };
/// A machine that sustains a speed of three where five is set.
const TOO_SLOW: Pace = Pace { set: 5.0, held_median: 3.0, behind_s: 10.0 };

fn start(folder: &Path) -> Start {
    start_on(HOLDS, folder)
}

fn start_on(machine: Pace, folder: &Path) -> Start {
    let library = Library::embedded().expect("embedded data");
    let protocol = Arc::new(Protocol::parse(PROTOCOL, "tiny.toml", &library).expect("parses"));
    let study = study_in_folder(protocol, "P01".parse().expect("a code"), folder).expect("begins");
    Start { study: Some(study.on_machine(machine)), ..Start::default() }
}

fn click(harness: &mut Harness<'static, SauteApp>, label: &str) {
    harness.get_by_label(label).click();
    steps(harness, 4);
}

fn stage(harness: &Harness<'static, SauteApp>) -> Stage {
    match harness.state().guided() {
        Some(Guided::Study(desk)) => desk.study().stage(),
        _ => panic!("no study"),
    }
}

fn rows(folder: &Path) -> Vec<LogRow> {
    let text = std::fs::read_to_string(folder.join("study-P01.csv")).expect("is written");
    from_csv("study-P01.csv", &text).expect("a log")
}

fn folder(name: &str) -> std::path::PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("studies").join(name);
    // It may be there from an earlier run.
    let _ = std::fs::remove_dir_all(&folder);
    folder
}

#[test]
fn a_whole_study_is_gone_through_and_its_rows_are_on_the_disk() {
    let folder = folder("whole");
    let mut harness = window_with(vec2(1280.0, 720.0), start(&folder));
    save(&mut harness, "study-consent");
    let witness = Witness::of(&mut harness);
    press(&mut harness, Key::Escape);
    assert_eq!(stage(&harness), Stage::Consent, "Esc closes no card of a study");
    click(&mut harness, "I agree and begin");
    save(&mut harness, "study-trial");
    click(&mut harness, "Begin");
    assert_eq!(harness.state().session().speed, 5.0);
    locks_hold(&mut harness);
    assert!(witness.told().is_paused, "this protocol states no sound");
    assert!(harness.query_by_role(Role::Switch).is_none() && harness.query_by_role(Role::Meter).is_none());
    cook(&mut harness, 25.5);
    assert_eq!(stage(&harness), Stage::CookForReal { phase: 1 }, "its time is over");
    assert_eq!(rows(&folder).last().map(|row| row.kind), Some(RowKind::Trial), "is on the disk at once");
    save(&mut harness, "study-real");
    enter_real(&mut harness);
    save(&mut harness, "study-trial-2");
    click(&mut harness, "Begin");
    second_trial(&mut harness);
    save(&mut harness, "study-questions");
    click(&mut harness, "6 (1 is not at all, 7 is very much)");
    click(&mut harness, "Done");
    assert_eq!(stage(&harness), Stage::Over);
    save(&mut harness, "study-over");
    check_rows(&folder);
}

/// Help, settings and messages can be read in a trial, and a photo cannot be taken: its time goes on.
fn no_card_stops_time(harness: &mut Harness<'static, SauteApp>) {
    for key in [Key::F1, Key::F2, Key::F3, Key::F8] {
        press(harness, key);
        let before = harness.state().session().kitchen.time_s();
        steps(harness, 2);
        assert!(harness.state().session().kitchen.time_s() > before, "{key:?}");
        press(harness, Key::Escape);
    }
}

/// What a study locks stays as it is.
fn locks_hold(harness: &mut Harness<'static, SauteApp>) {
    for key in [Key::CloseBracket, Key::Space, Key::R, Key::Num2, Key::X, Key::G, Key::F4] {
        press(harness, key);
    }
    let app = harness.state();
    assert!(app.session().speed == 5.0 && !app.session().paused && app.slice().is_none());
    assert!(app.settings().view == View::Look && !app.settings().curves_open);
    assert!(app.said().iter().any(|said| said == "This is locked here."), "{:?}", app.said());
    assert!(harness.query_by_label_contains("°C").is_none(), "no temperature is read");
    no_number_is_drawn(harness);
    save(harness, "study-blind");
    nothing_is_told_on_a_phone(harness);
    no_card_stops_time(harness);
    press(harness, Key::N);
    for locked in ["20×", "Pause", "Step", "Start over", "Undo", "Temperature", "Cut", "Set out", "Photo"] {
        assert!(harness.query_by_label(locked).is_none(), "{locked} gives away what there could be");
    }
    save(harness, "study-locked");
}

/// Nothing that is drawn tells a temperature.
fn no_number_is_drawn(harness: &Harness<'static, SauteApp>) {
    let told: Vec<_> = drawn_words(harness).into_iter().filter(|words| words.contains('°')).collect();
    assert!(told.is_empty(), "{told:?}");
}

/// A narrow window hides the same: neither readings nor the coach's cues.
fn nothing_is_told_on_a_phone(harness: &mut Harness<'static, SauteApp>) {
    let size = harness.ctx.content_rect().size();
    harness.set_size(vec2(390.0, 844.0));
    // A pan that heats has a cue.
    press(harness, Key::E);
    for told in ["°C", "Next to ", "As advised"] {
        assert!(harness.query_all_by_label_contains(told).next().is_none(), "{told}");
    }
    press(harness, Key::Q);
    harness.set_size(size);
    steps(harness, 3);
}

fn enter_real(harness: &mut Harness<'static, SauteApp>) {
    harness.get_by_label("Highest temperature in the middle").focus();
    steps(harness, 2);
    harness.get_by_label("Highest temperature in the middle").type_text("61.5");
    steps(harness, 3);
    harness.get_by_role_and_label(Role::Button, "medium").click();
    steps(harness, 4);
    click(harness, "Done");
}

/// Puts the steak in, takes it out, and ends the trial by the button.
fn second_trial(harness: &mut Harness<'static, SauteApp>) {
    press(harness, Key::E);
    press(harness, Key::A);
    cook(harness, 3.0);
    press(harness, Key::F);
    cook(harness, 3.0);
    crate::teaching::turned::turn_by_hand(harness);
    press(harness, Key::O);
    cook(harness, 3.0);
    save(harness, "study-out");
    no_number_is_drawn(harness);
    press(harness, Key::H);
    assert!(harness.query_by_label("Finish").is_some(), "also without panels");
    press(harness, Key::H);
    click(harness, "Finish");
    assert_eq!(stage(harness), Stage::Questionnaire { phase: 3 });
}

fn check_rows(folder: &Path) {
    let rows = rows(folder);
    let kinds: Vec<RowKind> = rows.iter().map(|row| row.kind).collect();
    use RowKind::{Answer, Consent, Entry, Trial};
    assert_eq!(kinds, [Consent, Trial, Entry, Entry, Trial, Answer]);
    assert_eq!((rows[2].value, rows[3].text.as_deref(), rows[5].value), (Some(61.5), Some("medium"), Some(6.0)));
    assert_eq!((rows[1].put_s, rows[4].flips), (None, Some(2)), "one by the key and one by the turner in the hand");
    assert!(rows[4].put_s < rows[4].out_s && rows[4].trial_wall_s.is_some());
    let pace = (rows[4].speed_set, rows[4].speed_held_median.is_some(), rows[4].behind_s.is_some());
    assert_eq!(pace, (Some(5.0), true, true), "what was held of the speed is kept");
    assert!(rows.iter().all(|row| !row.simulated && row.started.is_none()));
    let session = rows[4].session.clone().expect("is kept");
    let bytes = std::fs::read(folder.join(session)).expect("is there");
    assert!(saute_recipe::Recording::from_file(&bytes).is_ok());
    assert!(folder.join("data-dictionary.csv").exists() && folder.join("data-dictionary.md").exists());
}

#[test]
fn a_study_that_was_closed_goes_on_after_its_last_row_and_another_protocol_is_refused() {
    let folder = folder("closed");
    let mut harness = window_with(vec2(1280.0, 720.0), start(&folder));
    click(&mut harness, "I agree and begin");
    drop(harness);
    let path = folder.join("study-P01.csv");
    let cut = std::fs::read_to_string(&path).expect("reads") + "tiny,cut o";
    std::fs::write(&path, cut).expect("writes");
    let harness = window_with(vec2(1280.0, 720.0), start_on(TOO_SLOW, &folder));
    assert_eq!(stage(&harness), Stage::Trial { phase: 0, trial: 1 });
    harness.get_by_label("Try again");
    assert!(harness.query_by_label("Begin").is_none(), "no trial begins on a machine that does not hold its speed");
    drop(harness);
    let library = Library::embedded().expect("embedded data");
    let other = PROTOCOL.replace("max_s = 25", "max_s = 20");
    let protocol = Arc::new(Protocol::parse(&other, "tiny.toml", &library).expect("parses"));
    let refused = study_in_folder(protocol, "P01".parse().expect("a code"), &folder).expect_err("is refused");
    assert!(refused.contains("the protocol was changed"), "{refused}");
}

#[test]
fn who_does_not_agree_leaves_no_row() {
    let folder = folder("declined");
    let mut harness = window_with(vec2(1280.0, 720.0), start(&folder));
    click(&mut harness, "I do not take part");
    harness.get_by_label("Thank you. Nothing was stored.");
    assert!(rows(&folder).is_empty());
}

fn lesson(id: &str, is_locked: bool) -> Start {
    let library = Library::embedded().expect("embedded data");
    let scenario = Scenario::parse(shipped::text(id).expect("is shipped"), id, &library).expect("parses");
    let student = Some("S01".parse().expect("a code"));
    Start { lesson: Some(LessonStart { scenario: Arc::new(scenario), student, is_locked }), ..Start::default() }
}

/// How many orders the line gives.
fn orders(harness: &Harness<'static, SauteApp>) -> usize {
    harness.query_all_by_label_contains("As advised").count()
}

#[test]
fn a_lesson_pauses_and_asks_compares_the_answer_and_gives_a_row() {
    let pictures = folder("results");
    std::fs::create_dir_all(&pictures).expect("folder");
    let start = Start {
        desktop: DesktopOptions { pictures: Some(pictures.clone()), ..DesktopOptions::default() },
        ..lesson("when-to-flip", true)
    };
    let mut harness = window_with(vec2(1280.0, 720.0), start);
    save(&mut harness, "lesson-intro");
    assert!(harness.query_by_label("Leave the lesson").is_none(), "it is locked");
    click(&mut harness, "Begin");
    press(&mut harness, Key::A);
    cook(&mut harness, 80.0);
    assert!(!harness.state().session().paused);
    cook(&mut harness, 12.0);
    assert!(harness.state().session().paused, "a question is due");
    save(&mut harness, "lesson-question");
    harness.get_by_role_and_label(Role::Slider, "How much of the underside is brown now?").focus();
    steps(&mut harness, 2);
    (0..3).for_each(|_| press(&mut harness, Key::ArrowRight));
    click(&mut harness, "Answer");
    save(&mut harness, "lesson-truth");
    click(&mut harness, "Go on");
    assert!(!harness.state().session().paused);
    press(&mut harness, Key::O);
    cook(&mut harness, 3.0);
    click(&mut harness, "Finish");
    save(&mut harness, "lesson-rests");
    let mut frames = 0;
    while harness.query_by_label("Save the result").is_none() {
        steps(&mut harness, 1);
        frames += 1;
        assert!(frames < 2000, "it is cooked on until it has rested");
    }
    save(&mut harness, "lesson-result");
    assert_eq!(orders(&harness), 0, "the lesson is over");
    click(&mut harness, "Save the result");
    let text = std::fs::read_to_string(pictures.join("when-to-flip-S01.csv")).expect("is written");
    let rows = saute_study::class::from_csv("s.csv", &text).expect("a result");
    assert_eq!((rows[0].student.as_deref(), rows[0].q1_answer), (Some("S01"), Some(3.0)));
    assert!(rows[0].q1_truth.is_some() && rows[0].q2_answer.is_none());
}

#[test]
fn a_locked_lesson_takes_no_file_no_link_and_no_other_recipe_and_a_free_one_can_be_left() {
    let mut harness = window_with(vec2(1280.0, 720.0), lesson("first-steak", true));
    assert_eq!(orders(&harness), 0, "only the card says what to do");
    click(&mut harness, "Begin");
    steps(&mut harness, 2);
    assert_eq!(orders(&harness), 1);
    let pieces = harness.state().session().kitchen.pieces().len();
    harness.state_mut().open_link("#cook=1.damaged");
    press(&mut harness, Key::R);
    click(&mut harness, "Learn");
    assert!(harness.query_by_label("Lessons").is_none(), "the menu stays shut");
    assert_eq!(harness.state().session().kitchen.pieces().len(), pieces);
    let mut harness = window_with(vec2(1280.0, 720.0), lesson("first-steak", false));
    click(&mut harness, "Leave the lesson");
    assert!(harness.state().guided().is_none());
    click(&mut harness, "Learn");
    click(&mut harness, "Lessons");
    save(&mut harness, "lessons");
    click(&mut harness, "Carry-over: the steak cooks on");
    assert!(matches!(harness.state().guided(), Some(Guided::Lesson(desk)) if desk.scenario().id == "carry-over"));
}

#[test]
fn lessons_and_studies_fit_a_phone_and_speak_japanese() {
    let start = Start { language: Some(crate::harness::japanese()), ..lesson("first-steak", false) };
    let mut harness = window_with(vec2(390.0, 844.0), start);
    save(&mut harness, "lesson-intro-phone-ja");
    click(&mut harness, "始める");
    save(&mut harness, "lesson-ribbon-phone-ja");
    let folder = folder("phone");
    let mut harness = window_with(vec2(390.0, 844.0), self::start(&folder));
    save(&mut harness, "study-consent-phone");
    click(&mut harness, "I agree and begin");
    click(&mut harness, "Begin");
    save(&mut harness, "study-blind-phone");
    cook(&mut harness, 25.5);
    save(&mut harness, "study-real-phone");
}

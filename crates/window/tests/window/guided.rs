//! Promise: studies are gone through in the window: cards, ribbon, locks, hidden read-outs, rows and results.

use std::path::Path;
use std::sync::Arc;

use egui::accesskit::Role;
use egui::{Key, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use saute_controls::hands::Role as Held;
use saute_controls::kept::log_file::study_in_folder;
use saute_haptics::Pose;
use saute_haptics::device::Sensed;
use saute_kitchen::Library;
use saute_picture::View;
use saute_recipe::session::Replay;
use saute_recipe::{Recorder, Recording};
use saute_session::guided::{Guided, StudyDesk};
use saute_study::{Event, LogRow, Measures, Pace, Protocol, RowKind, Stage, Task, Times, from_csv};
use saute_window::{SauteApp, Start};

use crate::hand::{scripted, until};
use crate::harness::{cook, drawn_words, press, save, steps, window_with};
use crate::sound::Witness;
use crate::teaching::lesson::lesson;

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

pub fn click(harness: &mut Harness<'static, SauteApp>, label: &str) {
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

pub fn folder(name: &str) -> std::path::PathBuf {
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
    drop(harness);
    let mut harness = window_with(vec2(1280.0, 720.0), start(&folder));
    assert_eq!(stage(&harness), Stage::Trial { phase: 2, trial: 1 }, "the second day begins where the first ended");
    click(&mut harness, "Begin");
    take_device(&mut harness);
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

/// On the second day the pan hangs on strings.
fn take_device(harness: &mut Harness<'static, SauteApp>) {
    let (device, script) = scripted("spidar-frame", Sensed::Pose);
    let there = Pose::at(0.03, -0.02, 0.08);
    script.lock().expect("script").pose = there;
    let hands = &mut harness.state_mut().session_mut().hands;
    hands.hold(Held::Pan, "spidar-frame@here", device).expect("starts");
    let place = |app: &SauteApp| app.session().kitchen.world().motion.pose.position;
    assert!(until(harness, |app| (place(app) - there.position).length() < 1e-3), "the pan is in the hand");
    steps(harness, 2);
    harness.state_mut().session_mut().hands.disconnect(Held::Pan);
    assert!(until(harness, |app| !app.session().hands.has_pan()), "it is laid down");
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
    assert_eq!((rows[1].devices.as_deref(), rows[4].devices.as_deref()), (None, Some("pan:spidar-frame")));
    for row in [&rows[1], &rows[4]] {
        replays_to_its_columns(folder, row);
    }
    assert!(folder.join("data-dictionary.csv").exists() && folder.join("data-dictionary.md").exists());
}

/// The kept session of a trial, played again, gives the numbers of its row.
fn replays_to_its_columns(folder: &Path, row: &LogRow) {
    let bytes = std::fs::read(folder.join(row.session.as_deref().expect("is kept"))).expect("is there");
    let recording = Recording::from_file(&bytes).expect("a session").recording;
    let library = Library::embedded().expect("embedded data");
    let mut replay = Replay::begin(&recording, &library).expect("begins");
    let masses: Vec<f64> = replay.kitchen.pieces().iter().map(|piece| piece.mass()).collect();
    let mut seen = Recorder::default();
    while replay.moment().frame < recording.moment().frame {
        replay.advance_frame(&recording, &library);
        seen.observe(&replay.kitchen);
    }
    replay.settle(&recording, &library, recording.moment());
    assert_eq!((replay.departure(), replay.fault()), (None, None));
    let protocol = Protocol::parse(PROTOCOL, "tiny.toml", &library).expect("parses");
    let Task::Simulate(trials) = &protocol.phases[row.phase as usize - 1].task else { panic!("no trials") };
    let times = Times::of(&recording, &seen);
    let found = Measures::read(&replay.kitchen, &masses, &trials.goal, &times).to_two_places();
    assert_eq!((Some(found.score), Some(found.mark), Some(found.is_met)), (row.score, row.mark, row.is_met));
    assert_eq!((Some(found.core_peak_c), Some(found.lost_pct)), (row.core_peak_c, row.lost_pct));
    assert_eq!((Some(found.crust_pct), Some(found.charred_pct)), (row.crust_pct, row.charred_pct));
    assert_eq!((Some(found.target_share_pct), Some(found.beyond_pct)), (row.target_share_pct, row.beyond_pct));
    assert_eq!((Some(found.energy_kj), Some(found.grey_band_mm)), (row.energy_kj, row.grey_band_mm));
    assert_eq!((Some(found.flips), found.put_s, found.out_s), (row.flips, row.put_s, row.out_s));
    assert_eq!(Some(found.end_s), row.end_s);
}

#[test]
fn a_study_that_was_closed_goes_on_after_its_last_row_and_another_protocol_is_refused() {
    let folder = folder("closed");
    let mut first = StudyDesk::begin(start(&folder).study.expect("a study"), String::new());
    first.take(Event::Agreed).expect("is due");
    drop(first);
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

//! Promise: lessons are gone through in the window: they ask, compare the answer with what came, and lock.

use std::sync::Arc;

use egui::accesskit::Role;
use egui::{Key, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use saute_kitchen::Library;
use saute_session::guided::{Guided, LessonStart};
use saute_study::class::{Scenario, shipped};
use saute_window::{DesktopOptions, SauteApp, Start};

use crate::guided::{click, folder};
use crate::harness::{cook, press, save, steps, window_with};

pub fn lesson(id: &str, is_locked: bool) -> Start {
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
    cook(&mut harness, 140.0);
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

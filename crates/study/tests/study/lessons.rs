//! Promise: a lesson asks when it states, finds the truth in the cook, and its result is one row.

use std::path::Path;
use std::sync::Arc;

use saute_kitchen::{Command, Kitchen, Library, Piece, RestOn, celsius};
use saute_study::Measures;
use saute_study::class::rest::{Rest, has_rested, is_out};
use saute_study::class::{ClassSummary, Lesson, RestKind, ResultRow, Scenario, from_csv, shipped, to_csv};
use saute_study::simulated::SimulatedClass;

const TEXT: &str = r#"id = "quick"
title = "Quick"
intro = "Look."
goal = "medium"
[set_out]
food = "beef-lean"
size_mm = [60, 50, 15]
pan = "carbon-steel-26"
preheat_c = 180
[[predict]]
at_s = 1
ask = "core_now"
[[predict]]
after = "put"
after_s = 2
ask = "core_in"
in_s = 5
[[predict]]
after = "put"
after_s = 3
ask = "class_in_the_end"
"#;

fn lesson() -> (Lesson, Kitchen) {
    let library = Library::embedded().expect("embedded data");
    let scenario = Arc::new(Scenario::parse(TEXT, "quick.toml", &library).expect("parses"));
    let kitchen = scenario.recipe.kitchen(&library).expect("sets up");
    (Lesson::begin(scenario, Some("S01".parse().expect("a code"))), kitchen)
}

/// Steps until the lesson asks; returns when [s].
fn until_asked(lesson: &mut Lesson, kitchen: &mut Kitchen) -> f64 {
    loop {
        kitchen.step();
        if lesson.observe(kitchen) {
            return kitchen.time_s();
        }
        assert!(kitchen.time_s() < 60.0, "nothing is asked");
    }
}

/// Promise: a simulated student cooks, guesses and hands in what a lesson gives; the same seed gives the same row, and the results that are
/// shipped are of the shipped lesson.
#[test]
fn simulated_students_hand_in_what_is_collected() {
    let library = Library::embedded().expect("embedded data");
    let scenario = Arc::new(Scenario::parse(TEXT, "quick.toml", &library).expect("parses"));
    let class = SimulatedClass { scenario, seed: 1 };
    let rows: Vec<ResultRow> = [1, 2, 1].map(|number| class.row(number, &library).expect("cooks")).into();
    assert_eq!(rows[0], rows[2]);
    assert_ne!(rows[0].q1_answer, None);
    let (merged, summary) = ClassSummary::of(&rows);
    assert_eq!((merged.len(), summary.scenarios[0].students), (2, 2), "the third is the first");
    assert!(rows.iter().all(|row| row.rest == Some(RestKind::Seen) && row.q3_truth.is_some()), "{rows:?}");
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/class-results");
    let shipped_text = shipped::text("first-steak").expect("is shipped");
    let first = Scenario::parse(shipped_text, "first-steak.toml", &library).expect("parses");
    for number in 1..=5 {
        let file = folder.join(format!("first-steak-SIM-{number:02}.csv"));
        let text = std::fs::read_to_string(&file).expect("is shipped");
        let [row] = &from_csv("shipped", &text).expect("is read")[..] else { panic!("{}: one row", file.display()) };
        assert_eq!(row.checksum, format!("{:08x}", first.checksum), "make it anew: saute class simulate first-steak");
    }
}

#[test]
fn questions_come_when_they_are_due_one_by_one_and_the_truth_is_that_of_the_cook() {
    let (mut lesson, mut kitchen) = lesson();
    assert!(lesson.asks_ahead(), "what will be asked is not to be foretold");
    assert!((until_asked(&mut lesson, &mut kitchen) - 1.0).abs() < 0.11);
    assert_eq!((lesson.waiting(), lesson.answer(200.0)), (Some(0), None), "200 °C is no answer");
    assert_eq!(lesson.answer(7.0), Some(0));
    assert!((lesson.asked()[0].truth.expect("is known") - 5.0).abs() < 0.1);
    kitchen.apply(&Command::Put { food: "steak".into(), at: [0.0, 0.0], heap: false }).expect("goes in");
    let put_s = kitchen.time_s();
    assert!((until_asked(&mut lesson, &mut kitchen) - put_s - 2.0).abs() < 0.25);
    let asked_s = kitchen.time_s();
    lesson.answer(6.0);
    assert_eq!(lesson.asked()[1].truth, None, "it lies ahead");
    until_asked(&mut lesson, &mut kitchen);
    assert!(lesson.asks_ahead(), "the last question has no answer yet");
    lesson.answer(1.0);
    assert!(!lesson.asks_ahead(), "all is answered");
    while kitchen.time_s() < asked_s + 5.05 {
        kitchen.step();
        lesson.observe(&kitchen);
    }
    let core = celsius(kitchen.piece("steak").map(Piece::core).expect("is there"));
    assert!((lesson.asked()[1].truth.expect("has come") - core).abs() < 0.3);
    let measures = Measures { score: -3.0, at_core: 20.0, core_peak_c: 20.0, ..Measures::default() };
    assert!(Rest::of(&lesson, &kitchen).is_none(), "it is in the pan: what comes depends on what is done");
    let row = lesson.clone().end(&measures, RestKind::None);
    assert_eq!((row.q3_answer, row.q3_truth), (Some(1.0), None), "the end has not come");
    let row = lesson.end(&measures, RestKind::Seen);
    assert_eq!((row.q3_answer, row.q3_truth), (Some(1.0), Some(0.0)), "raw in the end");
    assert_eq!((row.scenario.as_str(), row.student.as_deref(), row.q4_answer), ("quick", Some("S01"), None));
}

/// A lesson whose questions are all answered, with its steak on the board after some time in the pan [s]; the hob is off.
fn on_the_board(in_pan_s: f64) -> (Lesson, Kitchen) {
    let (mut lesson, mut kitchen) = lesson();
    let give = |kitchen: &mut Kitchen, command: &Command| kitchen.apply(command).expect("is done");
    give(&mut kitchen, &Command::Hob(1100.0));
    until_asked(&mut lesson, &mut kitchen);
    lesson.answer(7.0);
    give(&mut kitchen, &Command::Put { food: "steak".into(), at: [0.0, 0.0], heap: false });
    let put_s = kitchen.time_s();
    for answer in [6.0, 1.0] {
        until_asked(&mut lesson, &mut kitchen);
        assert!(lesson.answer(answer).is_some());
    }
    until(&mut lesson, &mut kitchen, |kitchen| kitchen.time_s() >= put_s + in_pan_s);
    give(&mut kitchen, &Command::Rest { food: "steak".into(), on: RestOn::Board });
    until(&mut lesson, &mut kitchen, is_out);
    give(&mut kitchen, &Command::Hob(0.0));
    (lesson, kitchen)
}

/// Cooks on until something is so.
fn until(lesson: &mut Lesson, kitchen: &mut Kitchen, is_so: impl Fn(&Kitchen) -> bool) {
    while !is_so(kitchen) {
        kitchen.step();
        lesson.observe(kitchen);
        assert!(kitchen.time_s() < 1200.0, "it does not come");
    }
}

/// A steak that is taken out while it still warms, and a lesson that is ended at once: the rest is cooked on in a copy, and the truth is that
/// which a student would have seen who waited.
#[test]
fn what_time_has_not_shown_yet_is_cooked_on_in_a_copy_and_is_what_waiting_would_have_shown() {
    let (mut lesson, mut kitchen) = on_the_board(90.0);
    assert!(!has_rested(&kitchen));
    let mut ended = lesson.clone();
    let mut rest = Rest::of(&ended, &kitchen).expect("it rests");
    while !rest.tick(&mut ended) {}
    assert_eq!(rest.kind(), RestKind::CookedOn);
    until(&mut lesson, &mut kitchen, has_rested);
    assert!(ended.asked()[1].truth.is_some() && ended.asked() == lesson.asked(), "{:?}", ended.asked());
    assert_eq!(rest.kitchen().state_hash(), kitchen.state_hash());
}

/// A steak that is nearly raw warms on the board until it is as warm as the room: its end does not come, and is left empty.
#[test]
fn an_end_that_does_not_come_within_an_hour_stays_empty() {
    let (mut lesson, kitchen) = on_the_board(6.0);
    let mut rest = Rest::of(&lesson, &kitchen).expect("it rests");
    while !rest.tick(&mut lesson) {}
    assert_eq!((rest.kind(), (rest.lasted_s() - 3600.0).abs() < 0.2), (RestKind::None, true));
    let row = lesson.end(&Measures::default(), rest.kind());
    assert_eq!((row.q3_answer, row.q3_truth), (Some(1.0), None));
}

/// A result of before the rest was cooked on: the core "at most" is that of the instant at which *Finish* was pressed.
fn of_before(rest_s: f64) -> ResultRow {
    let text = shipped::text("first-steak").expect("is shipped");
    ResultRow {
        scenario: "first-steak".into(),
        checksum: format!("{:08x}", crc32fast::hash(text.as_bytes())),
        student: Some("S09".into()),
        core_peak_c: 5.42,
        out_s: Some(200.0),
        end_s: 200.0 + rest_s,
        q1_answer: Some(20.0),
        q1_truth: Some(18.0),
        q2_answer: Some(17.0),
        q2_truth: Some(5.42),
        ..ResultRow::default()
    }
}

#[test]
fn a_truth_of_before_that_was_noted_too_early_is_recognised_counted_and_left_out() {
    let early = of_before(2.0);
    assert_eq!(early.early_truths(), [1]);
    let text = to_csv(std::slice::from_ref(&early));
    let without_column: String =
        text.lines().map(|line| format!("{}\n", line.rsplit_once(',').expect("columns").0)).collect();
    let rows = from_csv("s.csv", &without_column).expect("a file of before");
    let (merged, summary) = ClassSummary::of(&rows);
    assert_eq!((merged[0].q1_truth, merged[0].q2_truth), (Some(18.0), None), "what had come is kept");
    let q = &summary.scenarios[0].questions;
    assert_eq!((q[0].compared, q[0].early_truths), (1, 0));
    assert_eq!((q[1].answers, q[1].compared, q[1].early_truths, q[1].median_error), (1, 0, 1, None));
    assert!(of_before(900.0).early_truths().is_empty(), "it had rested");
    let today = ResultRow { rest: Some(RestKind::CookedOn), ..early.clone() };
    assert!(today.early_truths().is_empty());
    let own = ResultRow { scenario: "own".into(), q3_truth: Some(2.0), ..early };
    assert_eq!(own.early_truths(), [1, 2], "5.42 is its peak, and 2 may be a class");
}

fn row(student: &str, score: f64, answer: f64) -> ResultRow {
    ResultRow {
        scenario: "quick".into(),
        checksum: "0".into(),
        student: Some(student.into()),
        goal: "medium".into(),
        is_met: score > 40.0,
        score,
        q1_answer: Some(answer),
        q1_truth: Some(50.0),
        ..ResultRow::default()
    }
}

#[test]
fn a_class_is_summed_up_and_each_result_counts_once() {
    let rows = [row("S02", 30.0, 40.0), row("S01", 50.0, 52.0), row("S02", 30.0, 40.0), row("S03", 60.0, 55.0)];
    let (merged, summary) = ClassSummary::of(&rows);
    assert_eq!(merged.iter().filter_map(|row| row.student.as_deref()).collect::<Vec<_>>(), ["S01", "S02", "S03"]);
    let [of_quick] = &summary.scenarios[..] else { panic!("one scenario") };
    assert_eq!((of_quick.results, of_quick.students, of_quick.met, of_quick.median_score), (3, 3, 2, 50.0));
    assert_eq!((of_quick.questions[0].answers, of_quick.questions[0].median_error), (3, Some(5.0)));
    let bars: Vec<_> = of_quick.questions[0].bars.iter().map(|bar| (bar.from, bar.answers, bar.truths)).collect();
    assert_eq!(bars, [(40.0, 1, 0), (50.0, 2, 3)]);
}

#[test]
fn a_result_comes_back_from_its_file_and_has_as_many_values_in_its_line() {
    let own = row("S01", 50.0, 52.0);
    let csv = to_csv(std::slice::from_ref(&own));
    assert_eq!(from_csv("s.csv", &csv).expect("reads"), std::slice::from_ref(&own));
    let columns = csv.lines().next().expect("a header").split(',').count();
    assert_eq!(own.line().split('\t').count(), columns);
    let strange = csv.replace("S01", "=HYPERLINK()");
    assert!(from_csv("s.csv", &strange).expect_err("no code").to_string().starts_with("s.csv:2: "));
    assert!(from_csv("s.csv", "a,b\n1,2\n").is_err());
}

/// The file of a student with one result.
fn handed_in() -> String {
    to_csv(&[row("S01", 50.5, 12.0)])
}

#[test]
fn a_result_that_a_spreadsheet_has_saved_again_or_without_headers_is_not_lost() {
    let text = handed_in();
    let own = from_csv("s.csv", &text).expect("a result");
    let (_, line) = text.split_once('\n').expect("a header");
    assert_eq!(from_csv("s.csv", line).expect("without headers"), own);
    let before = line.trim_end().rsplitn(3, ',').last().expect("columns");
    assert_eq!(from_csv("s.csv", before).expect("without headers, before the mark")[0].score, own[0].score);
    let german = text.replace(',', ";").replace('.', ",");
    assert_eq!(from_csv("s.csv", &german).expect("semicolons"), own);
    assert_eq!(from_csv("s.csv", &text.replace(',', "\t")).expect("tabs"), own);
}

#[test]
fn a_number_that_is_none_and_a_formula_are_refused_with_line_and_column() {
    let refused = |from: &str, to: &str| {
        let text = handed_in();
        assert!(text.contains(from), "{text}");
        from_csv("s.csv", &text.replacen(from, to, 1)).expect_err("refused").to_string()
    };
    for number in ["NaN", "inf", "-Infinity"] {
        let said = refused(",50.5,", &format!(",{number},"));
        assert!(said.starts_with("s.csv:2: \"score\" is ") && said.contains("no finite number"), "{said}");
    }
    let goal = row("S01", 50.5, 12.0).goal;
    for formula in ["=1+1", "@SUM(1)", "\"=HYPERLINK(\"\"http://x/\"\",\"\"a\"\")\"", "+1-2", "two words"] {
        let said = refused(&format!(",{goal},"), &format!(",{formula},"));
        assert!(said.starts_with("s.csv:2: \"goal\" is no id"), "{said}");
    }
    assert!(from_csv("s.csv", "one,two,three\n").expect_err("refused").message.contains("names no column"));
}

//! Promise: the events of a participant become the rows of the dictionary, in the order of the protocol; a log is gone on with.

use std::sync::Arc;

use saute_kitchen::Library;
use saute_study::dictionary::COLUMNS;
use saute_study::{
    Answer, Answers, Event, LogRow, Measures, Pace, Protocol, RowKind, Stage, Study, StudyError, from_csv, to_csv,
    with_all_columns,
};

use super::protocols::SMALL;

fn study() -> Study {
    let library = Library::embedded().expect("embedded data");
    let protocol = Protocol::parse(SMALL, "small.toml", &library).expect("parses");
    Study::begin(Arc::new(protocol), "P01".parse().expect("a code"))
}

/// A machine that held a little less than what was set.
const PACE: Pace = Pace { set: 5.0, held_median: 4.987_6, behind_s: 0.312 };

fn trial() -> Event {
    let measures = Measures { score: 41.234_56, target_share_pct: 47.0, flips: 2, end_s: 10.0, ..Measures::default() };
    let devices = Some("spidar-frame".to_owned());
    Event::TrialEnded { measures: Box::new(measures), wall_s: Some(12.34), pace: Some(PACE), session: None, devices }
}

fn answers(given: &[(&str, Answer)]) -> Event {
    Event::Answered(given.iter().map(|(id, answer)| ((*id).to_owned(), answer.clone())).collect::<Answers>())
}

/// All events of a participant.
fn events() -> Vec<Event> {
    vec![
        Event::Agreed,
        trial(),
        answers(&[("core_c", Answer::Number(61.0)), ("class", Answer::Choice(2))]),
        trial(),
        answers(&[("fun", Answer::Number(6.0))]),
    ]
}

fn rows() -> Vec<LogRow> {
    let mut study = study();
    let rows = events().into_iter().flat_map(|event| study.take(event, 100.04).expect("is due")).collect();
    assert_eq!(study.stage(), Stage::Over);
    rows
}

#[test]
fn a_way_through_a_protocol_gives_its_rows_in_order() {
    let kinds: Vec<RowKind> = rows().iter().map(|row| row.kind).collect();
    use RowKind::{Answer, Consent, Entry, Trial};
    assert_eq!(kinds, [Consent, Trial, Entry, Entry, Trial, Answer]);
    let rows = rows();
    assert_eq!((rows[1].score, rows[1].trial, rows[1].phase), (Some(41.23), Some(1), 1));
    let of_pace = (rows[1].speed_set, rows[1].speed_held_median, rows[1].behind_s);
    assert_eq!(of_pace, (Some(5.0), Some(4.99), Some(0.31)));
    assert_eq!((rows[1].devices.as_deref(), &rows[2].devices), (Some("spidar-frame"), &None));
    assert_eq!((rows[3].value, rows[3].text.as_deref()), (Some(3.0), Some("medium")));
    assert!(rows.iter().all(|row| row.elapsed_s == 100.0 && row.started.is_none() && !row.simulated));
}

#[test]
fn every_column_of_a_log_is_in_the_dictionary_and_every_value_in_its_range() {
    let csv = to_csv(&rows(), true);
    let mut reader = csv::Reader::from_reader(csv.as_bytes());
    let headers: Vec<String> = reader.headers().expect("headers").iter().map(str::to_owned).collect();
    assert_eq!(headers, COLUMNS.map(|column| column.name.to_owned()));
    check_values(&csv);
    assert_eq!(from_csv("log.csv", &csv).expect("reads"), rows());
}

/// A log of before a column was added is read, and gets that column before a row of today is appended to it.
#[test]
fn a_log_with_the_columns_of_before_gets_those_of_today() {
    let without =
        |row| LogRow { mark: None, speed_set: None, speed_held_median: None, behind_s: None, devices: None, ..row };
    let rows: Vec<LogRow> = rows().into_iter().map(without).collect();
    let today = to_csv(&rows, true);
    let without_last = |line: &str| line.rsplitn(6, ',').last().map(|before| format!("{before}\n")).expect("columns");
    let before: String = today.lines().map(without_last).collect();
    assert!(before.lines().next().is_some_and(|header| header.ends_with(",text")));
    assert_eq!(from_csv("before.csv", &before).expect("reads"), rows);
    assert_eq!(with_all_columns(&before, &rows).as_deref(), Some(today.as_str()));
    assert_eq!((with_all_columns(&today, &rows), with_all_columns("", &[])), (None, None));
}

/// Checks the numbers of a log against the dictionary.
pub fn check_values(csv: &str) {
    let mut reader = csv::Reader::from_reader(csv.as_bytes());
    for record in reader.records() {
        for (field, column) in record.expect("a row").iter().zip(COLUMNS) {
            if let (Some([low, high]), false) = (column.range, field.is_empty()) {
                let value: f64 = field.parse().unwrap_or_else(|_| panic!("{}: {field}", column.name));
                assert!((low..=high).contains(&value), "{}: {field}", column.name);
            }
        }
    }
}

#[test]
fn what_is_not_due_or_not_in_its_range_is_refused_and_nothing_changes() {
    let mut study = study();
    assert_eq!(study.take(trial(), 0.0), Err(StudyError::OutOfOrder));
    study.take(Event::Agreed, 0.0).expect("is due");
    study.take(trial(), 1.0).expect("is due");
    let stage = study.stage();
    let missing = answers(&[("core_c", Answer::Number(61.0))]);
    assert_eq!(study.take(missing, 2.0), Err(StudyError::Missing("class".into())));
    for (core, class) in [(Answer::Number(500.0), Answer::Choice(2)), (Answer::Number(61.0), Answer::Choice(9))] {
        let wrong = answers(&[("core_c", core), ("class", class)]);
        assert!(matches!(study.take(wrong, 2.0), Err(StudyError::OutOfRange(_))));
    }
    assert_eq!(study.stage(), stage);
}

#[test]
fn a_log_is_gone_on_with_after_its_last_whole_phase_and_only_by_its_own_study() {
    let all = rows();
    let stages: Vec<Stage> = (0..=all.len()).map(|k| study().resume(&all[..k]).expect("is its own").stage()).collect();
    assert_eq!(stages[0], Stage::Consent);
    assert_eq!(stages[2], Stage::CookForReal { phase: 1 });
    assert_eq!(stages[3], stages[2], "one of two values is not enough");
    assert_eq!(stages[6], Stage::Over);
    for change in [
        |row: &mut LogRow| row.participant = "P02".into(),
        |row: &mut LogRow| row.protocol = "00000000".into(),
        |row: &mut LogRow| row.phase = 7,
        |row: &mut LogRow| row.simulated = true,
    ] {
        let mut other = all.clone();
        change(&mut other[1]);
        assert!(matches!(study().resume(&other), Err(StudyError::OtherLog(_))));
    }
}

#[test]
fn the_time_of_day_is_kept_only_if_the_protocol_says_so() {
    let library = Library::embedded().expect("embedded data");
    for (says, is_kept) in [("", false), ("time_of_day = true\n", true)] {
        let protocol = Protocol::parse(&format!("{says}{SMALL}"), "small.toml", &library).expect("parses");
        let study = Study::begin(Arc::new(protocol), "P01".parse().expect("a code"));
        let rows = study.started_at("2026-11-24T06:00:00Z".into()).take(Event::Agreed, 0.0).expect("is due");
        assert_eq!(rows[0].started.is_some(), is_kept);
    }
}

#[test]
fn free_text_is_one_line_that_no_sheet_takes_for_a_formula() {
    let library = Library::embedded().expect("embedded data");
    let text = format!("allow_free_text = true\n{}", SMALL.replace("answer = \"likert\"", "answer = \"text\""));
    let protocol = Protocol::parse(&text, "small.toml", &library).expect("parses");
    let mut study = Study::begin(Arc::new(protocol), "P01".parse().expect("a code"));
    events().into_iter().take(4).for_each(|event| drop(study.take(event, 0.0).expect("is due")));
    let rows = study.take(answers(&[("fun", Answer::Text("=1+1\nyes".into()))]), 0.0).expect("is due");
    assert_eq!(rows[0].text.as_deref(), Some("'=1+1 yes"));
}

#[test]
fn a_log_with_a_number_that_is_none_is_refused_with_line_and_column() {
    let csv = to_csv(&rows(), true);
    let place = 1 + csv.lines().skip(1).position(|line| line.contains(",trial,")).expect("a trial");
    let mut lines: Vec<Vec<String>> = csv.lines().map(|line| line.split(',').map(str::to_owned).collect()).collect();
    let score = lines[0].iter().position(|name| name == "score").expect("a score");
    lines[place][score] = "NaN".to_owned();
    let text: String = lines.iter().map(|line| line.join(",") + "\n").collect();
    let error = from_csv("study-P01.csv", &text).expect_err("refused");
    assert_eq!(error.line, place as u64 + 1);
    assert!(error.message.starts_with("\"score\" is NaN, which is no finite number"), "{error}");
}

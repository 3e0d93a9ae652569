//! Promise: the analysis of the included logs gives the numbers that plain arithmetic gives, and logs that do not belong together are
//! refused.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Arc;

use saute_kitchen::Library;
use saute_study::analysis::{Mixed, Quantity, Span};
use saute_study::{Analysis, LogRow, Protocol, RowKind, Simulation, from_csv, shipped, to_csv};

use super::way::check_values;

/// The included logs, by their names.
fn included() -> BTreeMap<String, String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../studies/simulated");
    let entries = std::fs::read_dir(folder).expect("is included").map(|entry| entry.expect("an entry").path());
    let logs = entries.filter(|path| path.file_name().is_some_and(|n| n.to_string_lossy().starts_with("study-")));
    logs.map(|path| (path.display().to_string(), std::fs::read_to_string(&path).expect("reads"))).collect()
}

fn rows() -> Vec<LogRow> {
    included().iter().flat_map(|(name, text)| from_csv(name, text).expect("a log")).collect()
}

fn middle(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    let half = values.len() / 2;
    if values.len() % 2 == 1 { values[half] } else { (values[half - 1] + values[half]) / 2.0 }
}

#[test]
fn the_included_logs_are_twelve_small_ones_that_say_that_they_are_simulated() {
    let logs = included();
    assert!(logs.len() >= 12 && logs.values().map(String::len).sum::<usize>() < 100_000);
    logs.values().for_each(|text| check_values(text));
    assert!(rows().iter().all(|row| row.simulated && row.participant.starts_with('S') && row.started.is_none()));
    let protocol = Protocol::parse(
        shipped::text("2013").expect("is shipped"),
        "2013",
        &Library::embedded().expect("embedded data"),
    );
    assert_eq!(rows()[0].protocol, protocol.expect("parses").checksum_text(), "of the shipped protocol as it is");
}

/// The first participant cooks again what is in the included log: of one trial only, for it to be quick.
#[test]
fn a_simulated_participant_of_the_same_seed_does_the_same() {
    let library = Library::embedded().expect("embedded data");
    let text = shipped::text("2013").expect("is shipped");
    let short = text.replace("trials = 4", "trials = 1").replace("trials = 2", "trials = 1");
    let protocol = Arc::new(Protocol::parse(&short, "2013", &library).expect("parses"));
    let log = |seed| Simulation { protocol: Arc::clone(&protocol), seed }.log(1, &library).expect("cooks").1;
    let (once, again, other) = (log(1), log(1), log(2));
    assert_eq!(to_csv(&once, true), to_csv(&again, true));
    assert_ne!(once, other);
    let first = |rows: &[LogRow]| rows.iter().find(|row| row.kind == RowKind::Trial).expect("a trial").core_peak_c;
    let rows = rows();
    let own: Vec<LogRow> = rows.into_iter().filter(|row| row.participant == "S01").collect();
    assert!((first(&once).expect("measured") - first(&own).expect("measured")).abs() < 0.02);
}

#[test]
fn medians_of_the_curves_and_of_the_changes_are_those_of_plain_arithmetic() {
    let rows = rows();
    let analysis = Analysis::of(&rows, 1).expect("belong together");
    let trials: Vec<&LogRow> = rows.iter().filter(|row| row.kind == RowKind::Trial).collect();
    // Four trials before the stove and two after it.
    let number = |row: &LogRow| row.trial.expect("a number") + if row.phase == 1 { 0 } else { 4 };
    assert_eq!((analysis.real_after.as_slice(), analysis.simulated), ([4].as_slice(), true));
    for point in &analysis.curves {
        let here = trials.iter().filter(|row| row.condition == point.condition && number(row) == point.number);
        let values: Vec<f64> = here.filter_map(|row| point.quantity.of(row)).collect();
        let interval = point.interval.expect("nobody is missing");
        assert_eq!((point.n, point.missing), (values.len(), 0));
        assert!((interval.median - middle(values.clone())).abs() < 1e-9, "{point:?}");
        let ends = values.iter().fold([f64::MAX, f64::MIN], |[l, h], v| [l.min(*v), h.max(*v)]);
        assert!(ends[0] <= interval.low && interval.low <= interval.median, "{point:?}");
        assert!(interval.median <= interval.high && interval.high <= ends[1], "{point:?}");
    }
    let change = analysis.changes.iter().find(|change| {
        (change.quantity, change.span, change.condition.as_deref()) == (Quantity::Score, Span::Nearest, None)
    });
    let of = |who: &str, at: u32| {
        let row = trials.iter().find(|row| row.participant == who && number(row) == at).expect("a trial");
        row.score.expect("a score")
    };
    let codes: Vec<String> = (1..=12).map(|k| format!("S{k:02}")).collect();
    let differences = codes.iter().map(|who| of(who, 5) - of(who, 4)).collect();
    let change = change.expect("is compared");
    assert!((change.difference.median - middle(differences)).abs() < 1e-9 && change.n == 12, "{change:?}");
    assert!((change.before - middle(codes.iter().map(|who| of(who, 4)).collect())).abs() < 1e-9);
}

#[test]
fn what_is_missing_is_counted() {
    let mut rows = rows();
    rows.retain(|row| row.participant != "S02" || row.trial != Some(4));
    let analysis = Analysis::of(&rows, 1).expect("belong together");
    let lacking: usize = analysis.participants.iter().map(|taker| taker.missing_trials).sum();
    assert_eq!(lacking, 1);
    let missing: usize = analysis.curves.iter().filter(|p| p.quantity == Quantity::Score).map(|p| p.missing).sum();
    assert_eq!(missing, 1);
}

#[test]
fn logs_that_do_not_belong_together_are_refused_with_the_reason() {
    let all = rows();
    let changed = |change: fn(&mut LogRow)| {
        let mut rows = all.clone();
        let last = rows.len() - 1;
        change(&mut rows[last]);
        Analysis::of(&rows, 1).expect_err("is refused")
    };
    assert!(matches!(changed(|row| row.study = "other".into()), Mixed::Studies(named) if named == "2013, other"));
    assert!(matches!(changed(|row| row.protocol = "00000000".into()), Mixed::Versions(_)));
    assert_eq!(changed(|row| row.simulated = false), Mixed::Simulated);
    assert_eq!(Analysis::of(&[], 1), Err(Mixed::Empty));
    let twice = [all.clone(), all].concat();
    assert!(matches!(Analysis::of(&twice, 1), Err(Mixed::Twice(who, 1, 1)) if who == "S01"));
}

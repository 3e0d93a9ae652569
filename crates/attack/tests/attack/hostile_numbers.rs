//! Promise: a number in a data file is refused, or the kitchen works with it; nothing panics or hangs. One that is lost or
//! overflows is refused.
//!
//! Every number of some shipped files is replaced by numbers that are lost, huge, tiny, or at an end of their range.

use std::time::Duration;

use saute_attack::{Target, kept};
use saute_fixtures::processor;
use saute_kitchen::{Library, OwnFiles};

/// Numbers that replace each number of a file.
const HOSTILE: [&str; 10] = ["nan", "inf", "-inf", "1e308", "-1e308", "5e-324", "0", "-1", "1e-3", "1e6"];

/// Longest time of the processor for reading, building and ten ticks [s] (chosen: ten times what a sound file takes on a slow machine).
const LONGEST: Duration = Duration::from_secs(10);

/// Variable of the environment with which every number is replaced by every hostile number; else by two of them.
const CAMPAIGN: &str = "SAUTE_CAMPAIGN";

/// Returns the places of the numbers in a text, as byte ranges; those in texts and comments are left out.
fn numbers(text: &str) -> Vec<core::ops::Range<usize>> {
    let mut found = Vec::new();
    let (mut quoted, mut comment, mut start) = (false, false, None);
    let mut before = ' ';
    for (at, c) in text.char_indices() {
        let is_part = !quoted && !comment && (c.is_ascii_alphanumeric() || "+-._".contains(c));
        match (is_part, start) {
            (true, None) => start = Some(at),
            (false, Some(from)) => {
                start = None;
                if text[from..at].parse::<f64>().is_ok() {
                    found.push(from..at);
                }
            }
            _ => {}
        }
        if c == '"' && before != '\\' && !comment {
            quoted = !quoted;
        }
        comment = (comment || (c == '#' && !quoted)) && c != '\n';
        before = c;
    }
    found
}

/// Replaces every number of a shipped file by hostile numbers, one at a time.
fn attack(target: &str, path: &str) {
    attack_text(target, path, &Library::embedded_files()[path]);
}

/// Replaces every number of a text by hostile numbers, one at a time.
fn attack_text(target: &str, path: &str, text: &str) {
    let target = Target::named(target).expect("a target");
    let places = numbers(text);
    assert!(places.len() > 5, "{path}: {}", places.len());
    let count = if std::env::var_os(CAMPAIGN).is_some() { HOSTILE.len() } else { 2 };
    for (turn, place) in places.iter().enumerate() {
        for hostile in HOSTILE.into_iter().cycle().skip(3 * turn).take(count) {
            let changed = format!("{}{hostile}{}", &text[..place.start], &text[place.end..]);
            let ((), took) = processor::of_thread(|| target.run(changed.as_bytes()));
            let line = changed[..place.start].lines().count();
            assert!(took < LONGEST, "{path}:{line} with {hostile} took {took:?}");
        }
    }
}

#[test]
fn kinetics_with_any_number_are_refused_or_cook() {
    attack("kinetics", "kinetics/shrimp.toml");
    attack("kinetics", "kinetics/beef.toml");
}

#[test]
fn foods_with_any_number_are_refused_or_cook() {
    attack("food", "foods/beef-marbled.toml");
    attack("food", "foods/shrimp.toml");
}

#[test]
fn protocols_scenarios_goals_and_logs_of_studies_with_any_number_are_refused_or_read() {
    attack("goals", "goals.toml");
    for name in ["protocol", "scenario", "study_log"] {
        for seed in kept("seeds", Target::named(name).expect("a target")) {
            let text = String::from_utf8(seed.bytes).expect("a text");
            attack_text(name, &seed.path.display().to_string(), &text);
        }
    }
}

#[test]
fn sweeps_with_any_number_are_refused_or_cook() {
    let seeds = kept("seeds", Target::named("sweep").expect("a target"));
    for seed in seeds.into_iter().filter(|seed| seed.path.ends_with("every-table.toml")) {
        attack_text("sweep", "every-table.toml", &String::from_utf8(seed.bytes).expect("a text"));
    }
}

#[test]
fn pans_and_oils_with_any_number_are_refused_or_work() {
    attack("pan", "pans/cast-iron-grill-26.toml");
    attack("oil", "oils/butter.toml");
}

#[test]
fn a_nan_an_infinity_or_an_overflow_is_refused_in_every_file() {
    for (path, text) in Library::embedded_files() {
        if !["foods/", "kinetics/", "pans/", "oils/", "coatings/"].iter().any(|folder| path.starts_with(folder)) {
            continue;
        }
        for place in numbers(&text) {
            let hostile = ["nan", "inf", "1e308", "-1e308"][place.start % 4];
            let changed = format!("{}{hostile}{}", &text[..place.start], &text[place.end..]);
            let own = OwnFiles { texts: [(path.clone(), changed)].into(), ..OwnFiles::default() };
            let (_, faults) = Library::with_own(&own).expect("the shipped files are sound");
            assert!(!faults.is_empty(), "{path} accepts {hostile} at byte {}", place.start);
        }
    }
}

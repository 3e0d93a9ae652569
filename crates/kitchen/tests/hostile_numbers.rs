//! Promise: a number in a data file is refused, or the kitchen works with it; nothing panics or hangs.
//!
//! Every number of some shipped files is replaced by numbers that are lost, huge, tiny, or at an end of their range.

// A failed unwrap in a test reports its line.
#![allow(clippy::unwrap_used)]

use std::time::{Duration, Instant};

use saute_kitchen::food::{MeshSize, OutlineKind, Rules};
use saute_kitchen::{Command, Kitchen, Library, OwnFiles, PieceOrder, kelvin};

/// Numbers that replace each number of a file.
const HOSTILE: [&str; 10] = ["nan", "inf", "-inf", "1e308", "-1e308", "5e-324", "0", "-1", "1e-3", "1e6"];

/// Longest time for reading, building and ten ticks [s] (chosen: ten times what a sound file takes on a slow machine).
const LONGEST: Duration = Duration::from_secs(10);

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

/// Builds a kitchen with a pan and a food and advances it by ten ticks; refusals are allowed.
fn fry(library: &Library, pan: &str, food: &str) {
    let Ok(mut kitchen) = Kitchen::new(library, pan, kelvin(180.0)) else { return };
    let Some(description) = library.foods.get(food) else { return };
    let Some(size) = description.form.extent(&description.size.default_mm) else { return };
    let order = PieceOrder {
        id: "piece".into(),
        kind: food.into(),
        size: size.map(|mm| 1e-3 * mm),
        temperature: kelvin(5.0),
        seed: 1,
        coarseness: 3.0,
        mesh: MeshSize::Default,
        rules: Rules::Full,
        outline: OutlineKind::Plain,
    };
    if kitchen.add(library, &order).is_err() {
        return;
    }
    let _ = kitchen.apply(&Command::Hob(1500.0));
    let _ = kitchen.apply(&Command::Put { food: "piece".into(), at: [0.0, 0.0], heap: false });
    (0..10).for_each(|_| kitchen.step());
    let energy = kitchen.energy();
    let moved = energy.hob.abs() + energy.pan_stored.abs() + energy.evaporation.abs() + energy.air.abs();
    assert!(energy.imbalance.is_finite() && energy.imbalance.abs() < 1e-9 * moved.max(1.0), "{energy:?}");
}

/// Variable of the environment with which every number is replaced by every hostile number; else by two of them.
const CAMPAIGN: &str = "SAUTE_CAMPAIGN";

/// Replaces every number of a file by hostile numbers, one at a time.
fn attack(path: &str, pan: &str, food: &str) {
    let text = &Library::embedded_files()[path];
    let places = numbers(text);
    assert!(places.len() > 5, "{path}: {}", places.len());
    let count = if std::env::var_os(CAMPAIGN).is_some() { HOSTILE.len() } else { 2 };
    let mut accepted = 0;
    for (turn, place) in places.iter().enumerate() {
        for hostile in HOSTILE.into_iter().cycle().skip(3 * turn).take(count) {
            let start = Instant::now();
            let changed = format!("{}{hostile}{}", &text[..place.start], &text[place.end..]);
            let line = changed[..place.start].lines().count();
            let own = OwnFiles { texts: [(path.to_owned(), changed)].into(), ..OwnFiles::default() };
            let (library, faults) = Library::with_own(&own).unwrap();
            if faults.is_empty() {
                accepted += 1;
                fry(&library, pan, food);
            }
            assert!(start.elapsed() < LONGEST, "{path}:{line} with {hostile} took {:?}", start.elapsed());
        }
    }
    println!("{path}: {} numbers, {accepted} of {} changes accepted", places.len(), count * places.len());
}

#[test]
fn kinetics_with_any_number_are_refused_or_cook() {
    attack("kinetics/shrimp.toml", "carbon-steel-26", "shrimp");
    attack("kinetics/beef.toml", "carbon-steel-26", "beef-lean");
}

#[test]
fn foods_with_any_number_are_refused_or_cook() {
    attack("foods/beef-marbled.toml", "carbon-steel-26", "beef-marbled");
    attack("foods/shrimp.toml", "carbon-steel-26", "shrimp");
}

#[test]
fn pans_and_oils_with_any_number_are_refused_or_work() {
    attack("pans/cast-iron-grill-26.toml", "cast-iron-grill-26", "shrimp");
    attack("oils/butter.toml", "carbon-steel-26", "shrimp");
    attack("coatings/nonstick.toml", "carbon-steel-26-nonstick", "shrimp");
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
            let (_, faults) = Library::with_own(&own).unwrap();
            assert!(!faults.is_empty(), "{path} accepts {hostile} at byte {}", place.start);
        }
    }
}

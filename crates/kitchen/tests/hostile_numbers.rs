//! Promise: a number in a data file that is lost or overflows is refused. (What is accepted is cooked in saute-attack.)

// A failed unwrap in a test reports its line.
#![allow(clippy::unwrap_used)]

use saute_kitchen::{Library, OwnFiles};

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

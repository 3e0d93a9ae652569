//! The door of what another version stored: its sessions open with a note, its kitchens are refused with words.

use saute_attack::kitchen_files::LIBRARY;
use saute_kitchen::bytes::BytesError;
use saute_kitchen::{Kitchen, kelvin};
use saute_recipe::Recording;
use saute_recipe::session::SessionError;

use super::sessions::begun;

/// Bytes before each record of a session: its length and its checksum [-].
const RECORD_HEAD: usize = 8;

/// Place of the first record of a session, after its first line.
fn first_record(file: &[u8]) -> usize {
    file.iter().position(|byte| *byte == b'\n').expect("a first line") + 1
}

/// Place after the first record of a session.
pub(super) fn record_end(file: &[u8]) -> usize {
    let start = first_record(file);
    let length = u32::from_le_bytes(file[start..start + 4].try_into().expect("four bytes"));
    start + RECORD_HEAD + length as usize
}

/// A session file as another version of the program would have written it, and that version.
pub(super) fn of_another_version(file: &[u8]) -> (Vec<u8>, String) {
    let this = begun().beginning().program.clone();
    let other: String = this.chars().map(|c| if c.is_ascii_digit() { '9' } else { c }).collect();
    let (start, end) = (first_record(file) + RECORD_HEAD, record_end(file));
    let mut changed = file.to_vec();
    let place = start + file[start..end].windows(this.len()).position(|w| w == this.as_bytes()).expect("a version");
    changed[place..place + this.len()].copy_from_slice(other.as_bytes());
    let checksum = crc32fast::hash(&changed[start..end]).to_le_bytes();
    changed[start - 4..start].copy_from_slice(&checksum);
    (changed, other)
}

#[test]
fn a_session_of_another_version_opens_and_says_which_it_is() {
    let (file, version) = of_another_version(&begun().to_file());
    let opened = Recording::from_file(&file).expect("opens");
    let beginning = opened.recording.beginning();
    let recipe = beginning.recipe(&LIBRARY).expect("is sound");
    let said = beginning.difference(&recipe, &LIBRARY).expect("it differs");
    assert!(said.contains(&format!("was recorded by saute {version}")), "{said}");
}

#[test]
fn a_session_of_another_format_is_refused_with_words() {
    let file = String::from("saute session 7\n").into_bytes();
    let refused = Recording::from_file(&file).expect_err("another format");
    assert_eq!(refused, SessionError::Format("7".to_owned()));
    assert!(refused.to_string().contains("use the program that wrote it"), "{refused}");
}

#[test]
fn a_stored_kitchen_of_another_version_is_refused_with_words() {
    let bytes = Kitchen::new(&LIBRARY, "carbon-steel-26", kelvin(20.0)).expect("is shipped").to_bytes();
    // After the magic number come the format (two bytes), and the program's version with its length.
    for (place, word) in [(8, "format"), (11, "version")] {
        let mut changed = bytes.clone();
        changed[place] = if place == 8 { 77 } else { b'9' };
        let refused = Kitchen::from_bytes(&changed, &LIBRARY).expect_err("another version");
        assert!(matches!(refused, BytesError::Format { .. } | BytesError::Program { .. }), "{refused}");
        let said = refused.to_string();
        assert!(said.contains(word) || said.contains("stored by"), "{said}");
    }
}

//! Promise: no validation case disappears silently; every one is listed, and a removed one is named in the changelog.
//!
//! `SAUTE_BLESS=1 cargo test --release -p saute the_list_of_validation_cases` adds new cases to the list.

use std::collections::BTreeSet;
use std::fs::{create_dir, read_dir, read_to_string, remove_file, write};
use std::path::Path;

use tempfile::TempDir;

use crate::running::{Ran, saute};

/// A pan that stays at its temperature.
const CASE: &str = "name = \"pan\"\nsource = \"identity\"\nevidence = \"exact\"\nduration_s = 1\n\
    [pan]\nkind = \"cast-iron-26\"\ninitial_c = 20\n[[expect]]\nquantity = \"max\"\nvalue = 20\ntolerance = 0.1\n";

/// A folder with the cases "still" and "warm", both in its list, next to a changelog.
fn project() -> TempDir {
    let dir = tempfile::tempdir().unwrap();
    create_dir(dir.path().join("cases")).unwrap();
    for id in ["still", "warm"] {
        write(dir.path().join(format!("cases/{id}.toml")), CASE).unwrap();
    }
    write(dir.path().join("cases/index.txt"), "# names\nstill\nwarm\n").unwrap();
    write(dir.path().join("CHANGELOG.md"), "# Changelog\nThe pan is warm and still.\n").unwrap();
    dir
}

fn validate(dir: &TempDir) -> (Ran, serde_json::Value) {
    let mut command = saute();
    let ran: Ran =
        command.args(["validate", "--json", "--folder", "cases"]).current_dir(dir.path()).output().unwrap().into();
    let json = serde_json::from_str(&ran.out).unwrap_or_default();
    (ran, json)
}

#[test]
fn a_case_that_is_removed_without_an_entry_in_the_changelog_fails() {
    let dir = project();
    let (ran, json) = validate(&dir);
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    assert_eq!(json["cases"].as_array().unwrap().len(), 2);
    remove_file(dir.path().join("cases/warm.toml")).unwrap();
    let (ran, json) = validate(&dir);
    assert_eq!((ran.code, &json["removed"][0]), (Some(1), &"warm".into()), "{}", ran.err);
    assert!(
        ran.err.contains("cases/warm.toml: ")
            && ran.err.contains("remedy: restore the file, or write into CHANGELOG.md")
    );
    write(dir.path().join("CHANGELOG.md"), "- Validation case `warm` removed: its source was wrong.\n").unwrap();
    let (ran, json) = validate(&dir);
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    assert!(json["removed"].as_array().unwrap().is_empty() && !ran.err.contains("warm"), "{}", ran.err);
    remove_file(dir.path().join("CHANGELOG.md")).unwrap();
    assert_eq!(validate(&dir).0.code, Some(1), "without a changelog nothing is named");
}

#[test]
fn a_case_that_is_not_listed_is_reported_with_how_to_add_it() {
    let dir = project();
    write(dir.path().join("cases/new.toml"), CASE).unwrap();
    let (ran, json) = validate(&dir);
    assert_eq!((ran.code, &json["unlisted"][0]), (Some(0), &"new".into()), "{}", ran.err);
    assert!(ran.err.contains("remedy: add the line new to cases/index.txt"), "{}", ran.err);
}

#[test]
fn a_case_states_its_evidence_and_information_fails_nothing() {
    let dir = project();
    let path = dir.path().join("cases/still.toml");
    let wrong = CASE.replace("value = 20", "value = 30");
    write(&path, &wrong).unwrap();
    let (ran, json) = validate(&dir);
    assert_eq!((ran.code, &json["groups"][0]["hold"]), (Some(1), &1.into()), "{}", ran.out);
    write(&path, wrong.replace("\"exact\"", "\"information\"")).unwrap();
    let (ran, json) = validate(&dir);
    assert_eq!((ran.code, &json["groups"][1]["hold"]), (Some(0), &serde_json::Value::Null), "{}", ran.out);
    write(&path, wrong.replace("evidence = \"exact\"\n", "")).unwrap();
    let (ran, _) = validate(&dir);
    assert_eq!(ran.code, Some(2));
    assert!(ran.err.contains("cases/still.toml: evidence") && ran.err.contains("kitchen-band"), "{}", ran.err);
}

#[test]
fn the_list_of_validation_cases_has_every_file() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../validation");
    let list = folder.join("index.txt");
    let ids: BTreeSet<String> = read_dir(&folder)
        .unwrap()
        .filter_map(|entry| Some(entry.unwrap().file_name().to_str()?.strip_suffix(".toml")?.to_owned()))
        .collect();
    let text = read_to_string(&list).unwrap();
    let (comments, mut names): (Vec<&str>, BTreeSet<&str>) =
        (text.lines().filter(|l| l.starts_with('#')).collect(), text.lines().filter(|l| !l.starts_with('#')).collect());
    if std::env::var_os("SAUTE_BLESS").is_some() {
        names.extend(ids.iter().map(String::as_str));
        let lines: Vec<&str> = comments.into_iter().chain(names.iter().copied()).collect();
        write(&list, lines.join("\n") + "\n").unwrap();
    }
    let missing: Vec<&String> = ids.iter().filter(|id| !names.contains(id.as_str())).collect();
    assert!(missing.is_empty(), "validation/index.txt lacks {missing:?}: run this test with SAUTE_BLESS=1");
}

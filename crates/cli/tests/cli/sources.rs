//! Promise: every citation leads to an entry of `docs/refs.toml`, every entry is cited, and every number in `data/` states
//! where it comes from.

use std::collections::BTreeSet;
use std::fs::read_to_string;
use std::path::{Path, PathBuf};

use toml::{Table, Value};

const BIBLIOGRAPHY: &str = "docs/refs.toml";
/// Folders whose files cite sources as `[@key]`.
const CITING: [&str; 6] = ["data", "validation", "recipes", "gallery", "docs", "crates"];
const READ: [&str; 5] = ["toml", "md", "rs", "wgsl", "html"];
/// Words by which a `source` without a citation owns up.
const OWN: [&str; 2] = ["chosen", "estimate"];

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn files(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).unwrap_or_else(|e| panic!("{}: {e}", folder.display()));
    let paths = entries.map(|entry| entry.unwrap().path());
    let (folders, files): (Vec<_>, Vec<_>) = paths.partition(|path| path.is_dir());
    let readable = |path: &PathBuf| path.extension().is_some_and(|e| READ.iter().any(|read| e == *read));
    files.into_iter().filter(readable).chain(folders.iter().flat_map(|inner| self::files(inner))).collect()
}

/// Keys cited in a text: `[@key]` where the key is of lower-case letters, digits and hyphens.
fn cited(text: &str) -> Vec<&str> {
    let keys = text.split("[@").skip(1).filter_map(|rest| rest.split(']').next());
    keys.filter(|key| !key.is_empty() && key.chars().all(|c| matches!(c, 'a'..='z' | '0'..='9' | '-'))).collect()
}

fn bibliography() -> Table {
    read_to_string(root().join(BIBLIOGRAPHY)).unwrap().parse().unwrap()
}

/// Files that cite, with the text of each.
fn citing() -> Vec<(PathBuf, String)> {
    let folders = CITING.map(|folder| root().join(folder));
    let paths = folders.iter().flat_map(|folder| files(folder)).filter(|path| !path.ends_with(BIBLIOGRAPHY));
    let here = |path: &PathBuf| path.ends_with(file!());
    paths.filter(|path| !here(path)).map(|path| (path.clone(), read_to_string(path).unwrap())).collect()
}

/// Every `source` in a table and in the tables inside it.
fn sources(value: &Value) -> Vec<&str> {
    match value {
        Value::Table(table) => {
            let own = table.get("source").and_then(Value::as_str);
            own.into_iter().chain(table.values().flat_map(sources)).collect()
        }
        Value::Array(values) => values.iter().flat_map(sources).collect(),
        _ => Vec::new(),
    }
}

#[test]
fn every_citation_has_an_entry_and_every_entry_is_cited() {
    let entries: BTreeSet<String> = bibliography().keys().cloned().collect();
    let citing = citing();
    let mut used = BTreeSet::new();
    for (path, text) in &citing {
        for key in cited(text) {
            assert!(entries.contains(key), "{}: [@{key}] is not in {BIBLIOGRAPHY}", path.display());
            used.insert(key.to_owned());
        }
    }
    let idle: Vec<_> = entries.difference(&used).collect();
    assert!(idle.is_empty(), "nothing cites {idle:?}");
}

#[test]
fn every_entry_says_whether_it_is_checked_and_a_checked_one_is_complete() {
    for (key, entry) in &bibliography() {
        let checked = entry.get("checked").and_then(Value::as_bool);
        let has = |field: &str| entry.get(field).is_some();
        let complete = has("authors") && has("title") && has("year") && (has("journal") || has("publisher"));
        assert!(checked.is_some(), "{key} lacks checked");
        assert!(checked == Some(false) || complete, "{key} is checked, but lacks authors, title, year or journal");
    }
}

#[test]
fn every_source_in_the_data_cites_an_entry_or_says_that_it_is_chosen_or_estimated() {
    let mut found = 0;
    for path in files(&root().join("data")) {
        let table: Table = read_to_string(&path).unwrap().parse().unwrap();
        for source in sources(&Value::Table(table)) {
            found += 1;
            let own = source.to_lowercase();
            let answers = !cited(source).is_empty() || OWN.iter().any(|word| own.contains(word));
            assert!(answers, "{}: {source}", path.display());
        }
    }
    assert!(found > 100, "only {found} sources were found");
}

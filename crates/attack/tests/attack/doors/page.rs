//! The page of the doors is the table, and Python has the calls that it names.

use saute_attack::doors::{CHANGES, page};

fn root() -> std::path::PathBuf {
    std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// `SAUTE_BLESS=1` writes it.
#[test]
fn the_page_of_the_doors_is_the_table() {
    let path = root().join("docs/doors.md");
    if std::env::var_os("SAUTE_BLESS").is_some() {
        std::fs::write(&path, page()).unwrap();
    }
    let kept = std::fs::read_to_string(&path).unwrap_or_default();
    assert!(kept == page(), "docs/doors.md is not as generated: SAUTE_BLESS=1 writes it");
}

#[test]
fn python_has_every_call_of_the_table() {
    let stubs = std::fs::read_to_string(root().join("python/saute/__init__.pyi")).unwrap();
    for (call, _) in CHANGES.iter().filter_map(|change| change.python) {
        let (name, key) = call.trim_end_matches(')').split_once('(').unwrap();
        let start = stubs.find(&format!("    def {name}(")).unwrap_or_else(|| panic!("{call}"));
        let signature = &stubs[start..start + stubs[start..].find("->").unwrap()];
        assert!(key.is_empty() || signature.contains(&format!("{key}:")), "{call}: {signature}");
    }
}

//! Promise: `docs/formats` has the reference page of every file format, as `saute schema FORMAT --markdown` prints it.
//!
//! `SAUTE_BLESS=1 cargo test --release -p saute format_pages` writes the pages after a format has changed.

use std::path::Path;

use serde_json::Value;

use crate::running::run;

const FORMATS: [&str; 12] =
    ["food", "pan", "coating", "oil", "kinetics", "hob", "recipe", "lab", "rig", "study", "scenario", "sweep"];

fn page(format: &str) -> String {
    let ran = run(&["schema", format, "--markdown"]);
    assert_eq!(ran.code, Some(0), "{format}: {}", ran.err);
    ran.out
}

#[test]
fn the_page_of_every_format_is_the_one_in_the_docs() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/formats");
    for format in FORMATS {
        let (path, page) = (folder.join(format).with_extension("md"), page(format));
        if std::env::var_os("SAUTE_BLESS").is_some() {
            std::fs::create_dir_all(&folder).unwrap();
            std::fs::write(&path, &page).unwrap();
        }
        let committed = std::fs::read_to_string(&path).unwrap_or_default();
        assert!(committed == page, "docs/formats/{format}.md is not up to date: run this test with SAUTE_BLESS=1");
    }
}

#[test]
fn the_page_of_every_format_has_a_row_for_every_key_of_the_file() {
    for format in FORMATS {
        let page = page(format);
        let schema: Value = serde_json::from_str(&run(&["schema", format]).out).unwrap();
        for key in schema["properties"].as_object().unwrap().keys() {
            assert!(page.contains(&format!("\n| `{key}` | ")), "{format}: {key}");
        }
    }
}

#[test]
fn every_link_of_a_page_leads_to_one_of_its_tables() {
    for format in FORMATS {
        let page = page(format);
        let anchor = |line: &str| line.chars().filter(|c| c.is_alphanumeric() || "_-".contains(*c)).collect::<String>();
        let headings: Vec<String> = page.lines().filter_map(|line| line.strip_prefix("## ")).map(anchor).collect();
        for link in page.split("](#").skip(1).filter_map(|rest| rest.split(')').next()) {
            assert!(headings.iter().any(|heading| heading.to_lowercase() == link), "{format}: {link}");
        }
    }
}

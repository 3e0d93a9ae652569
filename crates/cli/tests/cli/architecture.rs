//! Promise: every name on the map exists: each file, link, crate, command and identifier that ARCHITECTURE.md mentions.

use std::collections::BTreeSet;
use std::fs::read_to_string;
use std::path::{Path, PathBuf};

use crate::running::run;

const MAP: &str = "ARCHITECTURE.md";
const MOST_LINES: usize = 200;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn map() -> String {
    read_to_string(root().join(MAP)).unwrap()
}

/// What is between backticks.
fn names(text: &str) -> Vec<&str> {
    text.split('`').skip(1).step_by(2).collect()
}

/// Targets of links: `[text](target)`.
fn links(text: &str) -> Vec<&str> {
    text.split("](").skip(1).filter_map(|rest| rest.split(')').next()).collect()
}

fn is_path(name: &str) -> bool {
    let endings = [".rs", ".toml", ".md", ".wgsl", ".html", ".sh", ".csv", ".svg"];
    name.contains('/') || endings.iter().any(|ending| name.ends_with(ending))
}

fn folders(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).unwrap_or_else(|e| panic!("{}: {e}", folder.display()));
    entries.map(|entry| entry.unwrap().path()).collect()
}

fn collect_words(path: &Path, words: &mut BTreeSet<String>) {
    if path.is_dir() {
        folders(path).iter().for_each(|inner| collect_words(inner, words));
    } else if path.extension().is_some_and(|e| e == "rs" || e == "wgsl") {
        let text = read_to_string(path).unwrap();
        let separate = |c: char| !(c.is_alphanumeric() || c == '_');
        words.extend(text.split(separate).filter(|w| !w.is_empty()).map(str::to_owned));
    }
}

/// Every word of the crates' sources.
fn words() -> BTreeSet<String> {
    let mut words = BTreeSet::new();
    let crates = folders(&root().join("crates"));
    crates.iter().chain([&root().join("python")]).for_each(|member| collect_words(&member.join("src"), &mut words));
    words
}

/// Names of the crates of this workspace.
fn members() -> BTreeSet<String> {
    let folders = |root: PathBuf| [folders(&root.join("crates")), vec![root.join("python")]].concat();
    let manifest = |member: PathBuf| read_to_string(member.join("Cargo.toml")).unwrap();
    let name = |text: String| text.parse::<toml::Table>().unwrap()["package"]["name"].as_str().unwrap().to_owned();
    folders(root()).into_iter().map(|member| name(manifest(member))).collect()
}

#[test]
fn every_name_on_the_map_exists() {
    let (text, words, members) = (map(), words(), members());
    for name in names(&text) {
        if let Some(arguments) = name.strip_prefix("saute ") {
            let mut arguments: Vec<&str> = arguments.split(' ').take_while(|a| !a.starts_with('-')).collect();
            arguments.push("--help");
            let said = run(&arguments);
            assert_eq!(said.code, Some(0), "`{name}` is no command: {}", said.err);
        } else if is_path(name) {
            assert!(root().join(name).exists(), "`{name}` is no file or folder");
        } else if name.contains('-') {
            assert!(members.contains(name), "`{name}` is no crate");
        } else {
            let parts = name.trim_end_matches("()").split("::").flat_map(|part| part.split('.'));
            for part in parts {
                assert!(words.contains(part), "`{name}`: {part} is no word of the sources");
            }
        }
    }
}

#[test]
fn every_link_on_the_map_leads_somewhere() {
    let text = map();
    let targets = links(&text);
    assert!(targets.len() > 10, "only {targets:?}");
    for target in targets.iter().filter(|t| !t.starts_with("http")) {
        let path = target.split('#').next().unwrap_or(target);
        assert!(root().join(path).exists(), "({target}) leads nowhere");
    }
}

#[test]
fn the_map_names_every_crate_and_fits_on_a_few_pages() {
    let text = map();
    for member in folders(&root().join("crates")) {
        let folder = format!("crates/{}", member.file_name().unwrap().to_string_lossy());
        assert!(text.contains(&folder), "{folder} is not on the map");
    }
    assert!(text.lines().count() < MOST_LINES, "{} lines", text.lines().count());
}

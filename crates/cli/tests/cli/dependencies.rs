//! Promise: every crate has a licence, a source and a single version as `deny.toml` lists them, and
//! [docs/third-party.md](../../../../docs/third-party.md) names all crates in the programs.
//!
//! Read are the crates of this machine's platform, which are on the disk; `cargo deny` judges those of all platforms.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use std::path::{Path, PathBuf};

use serde_json::Value;
use toml::Table;

use crate::layers::metadata;

/// The page of the crates in the programs.
const PAGE: &str = "docs/third-party.md";
/// The programs that people get.
const PROGRAMS: [&str; 2] = ["saute", "saute-spidar-sim"];
/// The line of the page after which the table of the crates begins; what is before it is written by hand.
const TABLE: &str = "<!-- Generated: SAUTE_BLESS=1 cargo test --release -p saute --test cli third_party -->\n";

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn rules() -> Table {
    std::fs::read_to_string(root().join("deny.toml")).unwrap().parse().unwrap()
}

fn texts(list: &toml::Value) -> BTreeSet<String> {
    list.as_array().unwrap().iter().map(|text| text.as_str().unwrap().to_owned()).collect()
}

fn text<'a>(package: &'a Value, key: &str) -> &'a str {
    package[key].as_str().unwrap_or_default()
}

/// Packages of others, of this platform, by their ids.
fn packages(metadata: &Value) -> BTreeMap<&str, &Value> {
    let used: BTreeSet<&str> =
        metadata["resolve"]["nodes"].as_array().unwrap().iter().map(|node| text(node, "id")).collect();
    let all = metadata["packages"].as_array().unwrap().iter();
    all.filter(|p| used.contains(text(p, "id")) && !p["source"].is_null()).map(|p| (text(p, "id"), p)).collect()
}

/// An SPDX expression of licences, read from left to right.
struct Expression<'a> {
    words: std::iter::Peekable<std::vec::IntoIter<String>>,
    allowed: &'a BTreeSet<String>,
}

impl<'a> Expression<'a> {
    /// Returns true if allowed licences satisfy an expression; a slash, as in old manifests, means "or".
    fn holds(text: &str, allowed: &'a BTreeSet<String>) -> bool {
        let spaced = text.replace('/', " OR ").replace('(', " ( ").replace(')', " ) ");
        let words: Vec<String> = spaced.split_whitespace().map(str::to_owned).collect();
        let mut expression = Self { words: words.into_iter().peekable(), allowed };
        let holds = expression.any();
        holds && expression.words.next().is_none()
    }

    fn takes(&mut self, word: &str) -> bool {
        self.words.next_if(|next| next == word).is_some()
    }

    fn any(&mut self) -> bool {
        let mut holds = self.all();
        while self.takes("OR") {
            holds |= self.all();
        }
        holds
    }

    fn all(&mut self) -> bool {
        let mut holds = self.one();
        while self.takes("AND") {
            holds &= self.one();
        }
        holds
    }

    fn one(&mut self) -> bool {
        if self.takes("(") {
            let holds = self.any();
            return self.takes(")") && holds;
        }
        let Some(mut name) = self.words.next() else { return false };
        if self.takes("WITH") {
            name += &format!(" WITH {}", self.words.next().unwrap_or_default());
        }
        self.allowed.contains(&name)
    }
}

#[test]
fn an_expression_of_licences_is_read_as_spdx_defines_it() {
    let allowed = ["MIT", "Zlib", "Apache-2.0 WITH LLVM-exception"].map(str::to_owned).into();
    for text in
        ["MIT", "MIT/GPL-3.0", "GPL-2.0 OR MIT AND Zlib", "(MIT OR X) AND Zlib", "Apache-2.0 WITH LLVM-exception"]
    {
        assert!(Expression::holds(text, &allowed), "{text}");
    }
    for text in ["", "GPL-3.0", "MIT AND GPL-3.0", "(MIT AND X) OR Apache-2.0", "Apache-2.0", "MIT MIT", "(MIT"] {
        assert!(!Expression::holds(text, &allowed), "{text}");
    }
}

#[test]
fn every_licence_is_allowed() {
    let (metadata, rules) = (metadata(), rules());
    let licences = &rules["licenses"];
    let mut unused: BTreeSet<&str> = BTreeSet::new();
    let mut own: BTreeMap<&str, BTreeSet<String>> = BTreeMap::new();
    for exception in licences["exceptions"].as_array().unwrap() {
        let name = exception["crate"].as_str().unwrap();
        own.insert(name, texts(&exception["allow"]));
        unused.insert(name);
    }
    let general = texts(&licences["allow"]);
    for package in packages(&metadata).values() {
        let name = text(package, "name");
        let mut allowed = general.clone();
        if !Expression::holds(text(package, "license"), &allowed) {
            unused.remove(name);
            allowed.extend(own.get(name).cloned().unwrap_or_default());
        }
        assert!(Expression::holds(text(package, "license"), &allowed), "{name}: licence {}", package["license"]);
    }
    assert!(unused.is_empty(), "exceptions that nothing needs: {unused:?}");
}

#[test]
fn every_source_is_allowed() {
    let metadata = metadata();
    let allowed = texts(&rules()["sources"]["allow-registry"]);
    for package in packages(&metadata).values() {
        let source = text(package, "source");
        let registry = source.strip_prefix("registry+").unwrap_or(source);
        assert!(allowed.contains(registry), "{} comes from {source}", package["name"]);
    }
}

#[test]
fn every_second_version_of_a_crate_is_listed_with_its_reason() {
    let (metadata, rules) = (metadata(), rules());
    let skips = rules["bans"]["skip"].as_array().unwrap();
    assert!(skips.iter().all(|skip| skip["reason"].as_str().is_some_and(|reason| !reason.is_empty())));
    // Those of other platforms are not on this disk; `cargo deny` judges them.
    let here = skips.iter().filter(|skip| !skip["reason"].as_str().is_some_and(|why| why.starts_with("elsewhere:")));
    let listed: BTreeSet<&str> = here.map(|skip| skip["crate"].as_str().unwrap()).collect();
    let mut versions: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
    for package in packages(&metadata).values() {
        versions.entry(text(package, "name")).or_default().push(text(package, "version"));
    }
    let mut found = BTreeSet::new();
    for (name, versions) in versions.iter().filter(|(_, versions)| versions.len() > 1) {
        let all: Vec<String> = versions.iter().map(|version| format!("{name}@{version}")).collect();
        let unlisted: Vec<&String> = all.iter().filter(|one| !listed.contains(one.as_str())).collect();
        assert_eq!(unlisted.len(), 1, "one version of each crate is not in bans.skip of deny.toml: {all:?}");
        found.extend(all);
    }
    let gone: Vec<&&str> = listed.iter().filter(|one| !found.contains(**one)).collect();
    assert!(gone.is_empty(), "versions in deny.toml that are no second ones: {gone:?}");
}

/// Ids of the packages that programs contain: what they need, and what is needed for building them.
fn in_programs(metadata: &Value) -> BTreeSet<&str> {
    let nodes = metadata["resolve"]["nodes"].as_array().unwrap();
    let by_id: BTreeMap<&str, &Value> = nodes.iter().map(|node| (text(node, "id"), node)).collect();
    let own = metadata["packages"].as_array().unwrap().iter().filter(|p| PROGRAMS.contains(&text(p, "name")));
    let mut open: Vec<&str> = own.map(|p| text(p, "id")).collect();
    let mut reached = BTreeSet::new();
    while let Some(id) = open.pop() {
        let needs = by_id[id]["deps"].as_array().unwrap().iter();
        let in_program = needs.filter(|dep| dep["dep_kinds"].as_array().unwrap().iter().any(|k| k["kind"] != "dev"));
        open.extend(in_program.map(|dep| text(dep, "pkg")).filter(|id| reached.insert(*id)));
    }
    reached
}

fn table(metadata: &Value) -> String {
    let reached = in_programs(metadata);
    let mut rows: Vec<String> = packages(metadata)
        .into_iter()
        .filter(|(id, _)| reached.contains(id))
        .map(|(_, p)| {
            let [name, version, licence, place] = ["name", "version", "license", "repository"].map(|key| text(p, key));
            format!("| {name} | {version} | {} | {place} |\n", licence.replace('/', " OR "))
        })
        .collect();
    rows.sort();
    let mut table = String::from("\n| crate | version | licence | source |\n|---|---|---|---|\n");
    rows.iter().for_each(|row| table.write_str(row).unwrap());
    table
}

/// `SAUTE_BLESS=1` writes the table.
#[test]
fn third_party_lists_every_crate_in_the_programs() {
    let path = root().join(PAGE);
    let page = std::fs::read_to_string(&path).unwrap();
    let (by_hand, kept) = page.split_once(TABLE).unwrap();
    let made = table(&metadata());
    assert!(made.lines().count() > 100, "{made}");
    if std::env::var_os("SAUTE_BLESS").is_some() {
        std::fs::write(&path, format!("{by_hand}{TABLE}{made}")).unwrap();
        return;
    }
    let difference = made.lines().find(|line| !kept.contains(line)).or(kept.lines().find(|line| !made.contains(line)));
    assert!(kept == made, "{PAGE} is not as generated, SAUTE_BLESS=1 writes it; the first difference: {difference:?}");
}

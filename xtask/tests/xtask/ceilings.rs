//! Promise: what makes the day long and can be counted without a run keeps to the ceilings of `scripts/durations.toml`: packages, test
//! programs, and how often egui and wgpu are linked. A ceiling that is higher than what is there fails too: it comes down.

// A test that fails at an unwrap names its line.
#![allow(clippy::unwrap_used)]

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::process::Command;

use serde_json::Value;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// The ceiling of a name in the file.
fn ceiling(name: &str) -> usize {
    let text = std::fs::read_to_string(root().join("scripts/durations.toml")).unwrap();
    let file: toml::Table = text.parse().unwrap();
    file["ceilings"][name].as_integer().unwrap() as usize
}

/// Packages and their dependencies on the platform of this compiler.
fn metadata() -> Value {
    let version = Command::new("rustc").args(["--version", "--verbose"]).output().unwrap().stdout;
    let version = String::from_utf8(version).unwrap();
    let host = version.lines().find_map(|line| line.strip_prefix("host: ")).unwrap();
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let arguments = ["metadata", "--format-version", "1", "--locked", "--offline", "--filter-platform", host];
    let output = Command::new(cargo).args(arguments).current_dir(root()).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    serde_json::from_slice(&output.stdout).unwrap()
}

/// What a package needs: of each dependency its id, and true if only its tests need it.
fn needs(metadata: &Value) -> BTreeMap<&str, Vec<(&str, bool)>> {
    let one = |dep: &'_ Value| dep["dep_kinds"].as_array().unwrap().iter().all(|kind| kind["kind"] == "dev");
    let nodes = metadata["resolve"]["nodes"].as_array().unwrap().iter();
    nodes
        .map(|node| {
            let deps = node["deps"].as_array().unwrap().iter();
            (node["id"].as_str().unwrap(), deps.map(|dep| (dep["pkg"].as_str().unwrap(), one(dep))).collect())
        })
        .collect()
}

/// All that is linked into what a package's programs, or also its tests, need.
fn linked<'a>(needs: &BTreeMap<&'a str, Vec<(&'a str, bool)>>, package: &'a str, tests: bool) -> BTreeSet<&'a str> {
    let mut found = BTreeSet::from([package]);
    let mut open: Vec<_> = needs[package].iter().filter(|(_, dev)| tests || !dev).map(|(id, _)| *id).collect();
    while let Some(id) = open.pop() {
        if found.insert(id) {
            open.extend(needs[id].iter().filter(|(_, dev)| !dev).map(|(id, _)| *id));
        }
    }
    found
}

/// A program that the run links.
struct Linked<'a> {
    is_test: bool,
    packages: BTreeSet<&'a str>,
}

/// All programs, libraries with unit tests and test programs of the workspace.
fn programs(metadata: &Value) -> Vec<Linked<'_>> {
    let needs = needs(metadata);
    let members: BTreeSet<_> = metadata["workspace_members"].as_array().unwrap().iter().map(Value::as_str).collect();
    let own =
        metadata["packages"].as_array().unwrap().iter().filter(|package| members.contains(&package["id"].as_str()));
    let mut found = Vec::new();
    for package in own {
        let id = package["id"].as_str().unwrap();
        for target in package["targets"].as_array().unwrap() {
            let kind = target["kind"][0].as_str().unwrap();
            if kind == "bin" {
                found.push(Linked { is_test: false, packages: linked(&needs, id, false) });
            }
            if target["test"] == true && ["lib", "bin", "test"].contains(&kind) {
                found.push(Linked { is_test: true, packages: linked(&needs, id, true) });
            }
        }
    }
    found
}

/// The count is at its ceiling, not above and not below.
fn at_ceiling(name: &str, count: usize) {
    let most = ceiling(name);
    assert!(count <= most, "{name}: {count}, and scripts/durations.toml allows {most}: make another one smaller");
    assert!(count == most, "{name}: {count}; bring the ceiling in scripts/durations.toml down from {most}");
}

#[test]
fn packages_test_programs_and_links_keep_to_their_ceilings() {
    let lock: toml::Table = std::fs::read_to_string(root().join("Cargo.lock")).unwrap().parse().unwrap();
    // Our own are rooms of the house, not what is brought into it.
    at_ceiling(
        "packages",
        lock["package"].as_array().unwrap().iter().filter(|one| one.get("source").is_some()).count(),
    );
    let metadata = metadata();
    let programs = programs(&metadata);
    at_ceiling("test_programs", programs.iter().filter(|program| program.is_test).count());
    let links = |name: &str| {
        let is = |id: &&str| id.rsplit('#').next().is_some_and(|rest| rest.split('@').next() == Some(name));
        programs.iter().filter(|program| program.packages.iter().any(is)).count()
    };
    at_ceiling("links_of_egui", links("egui"));
    at_ceiling("links_of_wgpu", links("wgpu"));
}

#[test]
fn packages_of_the_program_keep_to_their_ceiling() {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let arguments = ["tree", "--package", "saute", "--edges", "normal", "--prefix", "none", "--locked", "--offline"];
    let output = Command::new(cargo).args(arguments).current_dir(root()).output().unwrap();
    let tree = String::from_utf8(output.stdout).unwrap();
    // Name and version; a package that comes again, or is a macro, has a remark behind them.
    let outside = tree.lines().filter(|line| !line.contains(" (/"));
    let packages: BTreeSet<_> = outside.map(|line| line.split(' ').take(2).collect::<Vec<_>>()).collect();
    at_ceiling("packages_in_saute", packages.len());
}

//! Promise: a broken file in `--data` is named on stderr once, stops only the commands that need it, and never falls back to a
//! shipped file of the same id.

use std::path::Path;

use crate::running::{Ran, SHORT, run};

fn shipped(path: &str) -> String {
    std::fs::read_to_string(format!("{}/../../data/{path}", env!("CARGO_MANIFEST_DIR"))).unwrap()
}

fn fixture(name: &str) -> Vec<u8> {
    std::fs::read(format!("{}/../../fuzz/found/obj/{name}", env!("CARGO_MANIFEST_DIR"))).unwrap()
}

fn write(dir: &Path, name: &str, bytes: impl AsRef<[u8]>) {
    std::fs::create_dir_all(dir.join(name).parent().unwrap()).unwrap();
    std::fs::write(dir.join(name), bytes).unwrap();
}

fn run_with(dir: &Path, args: &[&str]) -> Ran {
    let data = dir.to_str().unwrap();
    run(&[args, &["--data", data]].concat())
}

/// Checks that a file is named once on stderr.
fn named_once(ran: &Ran, file: &Path) {
    assert_eq!(ran.err.matches(file.to_str().unwrap()).count(), 1, "{}", ran.err);
}

#[test]
fn a_broken_food_is_named_once_and_the_other_commands_go_on() {
    let dir = tempfile::tempdir().unwrap();
    write(dir.path(), "foods/beef-lean.toml", "name = 1");
    let file = dir.path().join("foods/beef-lean.toml");
    for args in [&["list", "pans"][..], &["list", "foods"], &["list", "scales"], &["cook", "shrimp", "--json"]] {
        let ran = run_with(dir.path(), args);
        assert_eq!(ran.code, Some(0), "{args:?}: {}", ran.err);
        named_once(&ran, &file);
    }
    let foods = run_with(dir.path(), &["list", "foods"]).out;
    assert!(!foods.contains("beef-lean ") && foods.contains("beef-marbled"), "{foods}");
}

#[test]
fn a_command_that_needs_a_broken_food_fails_and_does_not_use_the_shipped_one() {
    let dir = tempfile::tempdir().unwrap();
    write(dir.path(), "foods/beef-lean.toml", "name = 1");
    write(dir.path(), "short.toml", SHORT);
    let recipe = dir.path().join("short.toml");
    let ran = run_with(dir.path(), &["cook", recipe.to_str().unwrap()]);
    assert_eq!((ran.code, ran.out.as_str()), (Some(2), ""));
    named_once(&ran, &dir.path().join("foods/beef-lean.toml"));
    assert!(ran.err.contains("short.toml:8: food kind = \"beef-lean\" cannot be used"), "{}", ran.err);
}

#[test]
fn what_needs_broken_kinetics_or_a_broken_coating_is_set_aside_with_it() {
    let dir = tempfile::tempdir().unwrap();
    write(dir.path(), "kinetics/beef.toml", "change = []");
    write(dir.path(), "coatings/nonstick.toml", "");
    let short = dir.path().join("short.toml");
    let cook = |text: &str| {
        write(dir.path(), "short.toml", text);
        run_with(dir.path(), &["cook", short.to_str().unwrap()])
    };
    let beef = cook(SHORT);
    assert!(beef.code == Some(2) && beef.err.contains("the file of its kinetics \"beef\""), "{}", beef.err);
    let coated = cook(&SHORT.replace("carbon-steel-26", "carbon-steel-26-nonstick"));
    assert!(coated.code == Some(2) && coated.err.contains("of its coating"), "{}", coated.err);
    assert_eq!(run_with(dir.path(), &["list", "pans"]).code, Some(0));
}

#[test]
fn a_broken_oil_or_scale_stops_only_what_needs_it() {
    for (name, reason) in [("oils/canola.toml", "\"canola\" cannot be used"), ("doneness.toml", "--doneness")] {
        let dir = tempfile::tempdir().unwrap();
        write(dir.path(), name, "nonsense = 1");
        let listed = run_with(dir.path(), &["list", "foods"]);
        assert_eq!(listed.code, Some(0), "{name}: {}", listed.err);
        named_once(&listed, &dir.path().join(name));
        write(dir.path(), "short.toml", SHORT);
        let ran = run_with(dir.path(), &["cook", dir.path().join("short.toml").to_str().unwrap()]);
        assert!(ran.code == Some(2) && ran.err.contains(reason), "{name}: {}", ran.err);
    }
}

#[test]
fn a_surface_without_area_stops_neither_lists_nor_cooks_of_other_foods() {
    let dir = tempfile::tempdir().unwrap();
    let food = shipped("foods/beef-lean.toml").replace("form = \"steak\"", "form = \"mesh\"");
    let without = |text: &str, table: &str| {
        let start = text.find(table).unwrap();
        let end = text[start + 1..].find("\n[").map_or(text.len(), |at| start + 1 + at);
        format!("{}{}", &text[..start], &text[end..])
    };
    let food = ["[size]", "[outline]", "[natural]", "[fat_cap]"].iter().fold(food, |food, table| without(&food, table));
    write(
        dir.path(),
        "foods/own.toml",
        food + "\n[mesh]\nfile = \"one-point.obj\"\nsource = \"own\"\nconfidence = \"low\"\n",
    );
    write(dir.path(), "foods/one-point.obj", fixture("one-point.obj"));
    let ran = run_with(dir.path(), &["list", "foods"]);
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    assert!(ran.err.contains("triangles without area: 1"), "{}", ran.err);
    named_once(&ran, &dir.path().join("foods/own.toml"));
}

#[test]
fn a_file_that_is_not_text_or_too_long_is_broken_too() {
    let dir = tempfile::tempdir().unwrap();
    write(dir.path(), "pans/carbon-steel-26.toml", [0xff, 0xfe]);
    write(dir.path(), "recipes/medium.toml", "#".repeat(5 << 20));
    let ran = run_with(dir.path(), &["list", "foods"]);
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    named_once(&ran, &dir.path().join("pans/carbon-steel-26.toml"));
    named_once(&ran, &dir.path().join("recipes/medium.toml"));
    let pans = run_with(dir.path(), &["list", "pans"]).out;
    assert!(!pans.contains("carbon-steel-26") && pans.contains("cast-iron-26"), "{pans}");
    let cooked = run_with(dir.path(), &["cook", "medium"]);
    assert!(cooked.code == Some(2) && cooked.err.contains("medium: cannot be used"), "{}", cooked.err);
}

#[cfg(unix)]
#[test]
fn a_pipe_among_the_files_does_not_block() {
    let dir = tempfile::tempdir().unwrap();
    std::fs::create_dir(dir.path().join("foods")).unwrap();
    let pipe = dir.path().join("foods/pipe.toml");
    assert!(std::process::Command::new("mkfifo").arg(&pipe).status().unwrap().success());
    let ran = run_with(dir.path(), &["list", "foods"]);
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    named_once(&ran, &pipe);
}

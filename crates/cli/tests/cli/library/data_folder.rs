//! `--data DIR`.

use std::path::Path;

use crate::running::{SHORT, run};

fn shipped(path: &str) -> String {
    std::fs::read_to_string(format!("{}/../../data/{path}", env!("CARGO_MANIFEST_DIR"))).unwrap()
}

fn write(dir: &Path, name: &str, text: &str) {
    std::fs::create_dir_all(dir.join(name).parent().unwrap()).unwrap();
    std::fs::write(dir.join(name), text).unwrap();
}

#[test]
fn foods_pans_and_recipes_of_the_user_are_added() {
    let dir = tempfile::tempdir().unwrap();
    let data = dir.path().to_str().unwrap();
    write(dir.path(), "foods/flank.toml", &shipped("foods/beef-lean.toml").replace("Lean beef steak", "Flank"));
    write(dir.path(), "pans/billy.toml", &shipped("pans/carbon-steel-26.toml").replace("Carbon steel, 26 cm", "Billy"));
    write(
        dir.path(),
        "recipes/mine.toml",
        &SHORT.replace("beef-lean", "flank").replace("carbon-steel-26", "billy-nonstick"),
    );
    assert!(run(&["list", "foods", "--data", data]).out.contains("Flank"));
    assert!(run(&["--data", data, "list", "pans"]).out.contains("Billy"));
    let ran = run(&["cook", "mine", "--data", data]);
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    assert!(ran.out.contains("flank"));
}

#[test]
fn a_file_of_the_same_name_replaces_the_shipped_one() {
    let dir = tempfile::tempdir().unwrap();
    write(
        dir.path(),
        "pans/carbon-steel-26.toml",
        &shipped("pans/carbon-steel-26.toml").replace("Carbon steel, 26 cm", "Heirloom"),
    );
    let ran = run(&["list", "pans", "--data", dir.path().to_str().unwrap()]);
    assert!(ran.out.contains("Heirloom") && !ran.out.contains("Carbon steel, 26 cm"), "{}", ran.out);
}

#[test]
fn a_mistake_in_the_folder_is_named_with_its_file_and_line() {
    let dir = tempfile::tempdir().unwrap();
    let data = dir.path().to_str().unwrap();
    let pan = shipped("pans/carbon-steel-26.toml").replace("thickness_mm = 2.5", "thickness_mm = \"thick\"");
    let line = 1 + pan.lines().position(|l| l.contains("thick\"")).unwrap();
    write(dir.path(), "pans/odd.toml", &pan);
    let ran = run(&["list", "pans", "--data", data]);
    // The list goes on without the broken pan: `broken_data` has the promises.
    assert_eq!(ran.code, Some(0));
    let place = format!("{}:{line}:", dir.path().join("pans/odd.toml").display());
    assert!(ran.err.contains(&place) && ran.err.contains("remedy"), "{}", ran.err);
}

#[test]
fn a_mistake_in_a_recipe_of_the_folder_is_named_with_its_file_and_line() {
    let dir = tempfile::tempdir().unwrap();
    write(dir.path(), "recipes/odd.toml", &SHORT.replace("flip =", "flop ="));
    for (args, code) in [(["cook", "odd"], 2), (["list", "recipes"], 0)] {
        let ran = run(&[args[0], args[1], "--data", dir.path().to_str().unwrap()]);
        let place = format!("{}:17:", dir.path().join("recipes/odd.toml").display());
        assert!(ran.code == Some(code) && ran.err.contains(&place), "{}", ran.err);
    }
}

#[test]
fn a_folder_that_is_missing_or_holds_nothing_to_read_is_refused() {
    let dir = tempfile::tempdir().unwrap();
    let (missing, file) = (dir.path().join("missing"), dir.path().join("file"));
    std::fs::write(&file, "").unwrap();
    for (data, part) in [
        (&missing, "does not exist"),
        (&file, "is not a folder"),
        (&dir.path().to_owned(), "contains none of the folders"),
    ] {
        let ran = run(&["list", "foods", "--data", data.to_str().unwrap()]);
        assert_eq!(ran.code, Some(2));
        assert!(
            ran.err.contains(part) && ran.err.contains("remedy") && ran.err.contains(data.to_str().unwrap()),
            "{}",
            ran.err
        );
    }
}

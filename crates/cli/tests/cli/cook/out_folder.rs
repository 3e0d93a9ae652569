//! `--out DIR` without permission or space, and with files of an earlier cook.

use std::path::Path;

use crate::running::{SHORT, names_in, run};

fn short(dir: &Path) -> String {
    let path = dir.join("short.toml");
    std::fs::write(&path, SHORT).unwrap();
    path.to_str().unwrap().to_owned()
}

#[test]
fn a_folder_that_cannot_be_made_is_reported_before_the_cook_starts() {
    let dir = tempfile::tempdir().unwrap();
    let recipe = short(dir.path());
    // Nothing can be created below a file, not even by root.
    let out = Path::new(&recipe).join("below/a/file");
    let ran = run(&["cook", &recipe, "--out", out.to_str().unwrap()]);
    assert_eq!((ran.code, ran.out.as_str()), (Some(2), ""));
    assert!(ran.err.contains(out.to_str().unwrap()) && ran.err.contains("remedy"), "{}", ran.err);
}

#[cfg(unix)]
#[test]
fn a_disk_that_takes_no_more_is_reported_before_the_cook_starts_and_nothing_stays_behind() {
    let dir = tempfile::tempdir().unwrap();
    let recipe = short(dir.path());
    let out = dir.path().join("new/out");
    // A limit on the size of files has the same effect as a full disk: writing fails in the same place.
    let script = "trap '' XFSZ; ulimit -f 64; exec \"$0\" cook \"$1\" --out \"$2\"";
    let output = std::process::Command::new("sh")
        .args(["-c", script, env!("CARGO_BIN_EXE_saute"), &recipe])
        .arg(&out)
        .output()
        .unwrap();
    let err = String::from_utf8(output.stderr).unwrap();
    assert_eq!((output.status.code(), output.stdout.len()), (Some(2), 0), "{err}");
    assert!(err.contains("free some space"), "{err}");
    assert!(!dir.path().join("new").exists());
}

#[test]
fn a_second_cook_into_the_same_folder_replaces_the_first_and_leaves_other_files_alone() {
    let dir = tempfile::tempdir().unwrap();
    let recipe = short(dir.path());
    let out = dir.path().join("out");
    std::fs::create_dir(&out).unwrap();
    for name in ["section_99_flip.png", "section_of_my_house.png", "notes.txt", "summary.json"] {
        std::fs::write(out.join(name), "old").unwrap();
    }
    let ran = run(&["cook", &recipe, "--out", out.to_str().unwrap()]);
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    let names = names_in(&out);
    assert!(!names.contains(&"section_99_flip.png".to_owned()));
    assert!(names.contains(&"section_of_my_house.png".to_owned()) && names.contains(&"notes.txt".to_owned()));
    assert!(names.iter().all(|n| !n.starts_with('.')), "{names:?}");
    assert_ne!(std::fs::read_to_string(out.join("summary.json")).unwrap(), "old");
}

#[test]
fn a_step_that_goes_wrong_while_cooking_leaves_nothing_behind() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("large.toml");
    std::fs::write(&path, SHORT.replace("put = \"steak\"", "put = \"steak\"\nat_mm = [90, 0]")).unwrap();
    let out = dir.path().join("out");
    let ran = run(&["cook", path.to_str().unwrap(), "--out", out.to_str().unwrap()]);
    assert_eq!((ran.code, ran.out.as_str()), (Some(2), ""));
    assert!(
        ran.err.contains("large.toml:13:") && ran.err.contains("does not fit") && ran.err.contains("remedy"),
        "{}",
        ran.err
    );
    assert!(!out.exists());
}

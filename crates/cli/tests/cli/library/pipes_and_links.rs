//! Promise: a pipe, a device or a link out of the `--data` folder is refused by name; nothing waits for it or reads it to its end.

#![cfg(unix)]

use std::os::unix::fs::symlink;
use std::path::Path;
use std::process::Command;

use crate::running::{SHORT, run};

fn pipe(path: &Path) -> String {
    assert!(Command::new("mkfifo").arg(path).status().unwrap().success());
    path.to_str().unwrap().to_owned()
}

#[test]
fn no_command_waits_for_a_pipe_or_reads_a_device_to_its_end() {
    let dir = tempfile::tempdir().unwrap();
    let [recipe, session, log] = ["a.toml", "a.saute", "a.csv"].map(|name| pipe(&dir.path().join(name)));
    for args in [
        vec!["cook", &recipe],
        vec!["cook", "/dev/zero"],
        vec!["replay", &session],
        vec!["replay", "/dev/zero"],
        vec!["lab", &recipe],
        vec!["food", "check", &recipe],
        vec!["fit", &log, "--recipe", "medium"],
    ] {
        let ran = run(&args);
        assert_eq!(ran.code, Some(2), "{args:?}: {ran:?}");
        assert!(ran.err.contains("is a pipe or a device, not a file"), "{args:?}: {}", ran.err);
        assert!(ran.err.contains("remedy: name a"), "{args:?}: {}", ran.err);
    }
}

#[test]
fn a_pipe_and_a_link_out_of_the_data_folder_are_set_aside_by_name_and_the_rest_is_read() {
    let dir = tempfile::tempdir().unwrap();
    let data = dir.path().join("data");
    let recipes = data.join("recipes");
    std::fs::create_dir_all(&recipes).unwrap();
    std::fs::write(dir.path().join("secret.toml"), SHORT).unwrap();
    std::fs::write(recipes.join("mine.toml"), SHORT).unwrap();
    symlink(dir.path().join("secret.toml"), recipes.join("out.toml")).unwrap();
    symlink(recipes.join("mine.toml"), recipes.join("same.toml")).unwrap();
    pipe(&recipes.join("pipe.toml"));
    let args = |recipe| ["cook", recipe, "--data", data.to_str().unwrap()];
    let mine = run(&args("mine"));
    assert_eq!(mine.code, Some(0), "{}", mine.err);
    for part in ["pipe.toml: is a pipe or a device", "out.toml: leads out of --data", "secret.toml"] {
        assert!(mine.err.contains(part), "{part}: {}", mine.err);
    }
    assert_eq!(run(&args("same")).code, Some(0), "a link within the folder is read");
    assert_eq!(run(&args("out")).code, Some(2), "what lies outside is not read");
}

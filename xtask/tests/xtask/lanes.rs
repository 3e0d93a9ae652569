//! Promises of steps side by side (`scripts/lanes.sh`): they run at the same time and in the order of what they need; the first failure
//! ends the others and states how to run that step alone; each leaves its times.

// A test that fails at an unwrap names its line.
#![allow(clippy::unwrap_used)]
#![cfg(target_os = "linux")]

use std::path::Path;
use std::process::{Command, Output};

/// A script with its own steps, in its own folder.
fn script(folder: &Path, steps: &str, list: &str) -> Command {
    let scripts = Path::new(env!("CARGO_MANIFEST_DIR")).join("../scripts").canonicalize().unwrap();
    let scripts = scripts.display();
    let text = format!(
        "set -euo pipefail\nsource {scripts}/requirements.sh\nsource {scripts}/steps.sh\nsource {scripts}/lanes.sh\n{steps}\n\
         if [ \"${{1:-}}\" = step ]; then run_step \"$2\"; else side_by_side {list}; echo all; fi\n"
    );
    let file = folder.join("steps.sh");
    std::fs::write(&file, text).unwrap();
    let mut command = Command::new("bash");
    command.arg(file).current_dir(folder).env("CARGO_TARGET_DIR", folder.join("target"));
    command
}

fn ran(folder: &Path, steps: &str, list: &str) -> Output {
    script(folder, steps, list).output().unwrap()
}

fn said(output: &Output) -> String {
    String::from_utf8_lossy(&output.stdout).into_owned() + &String::from_utf8_lossy(&output.stderr)
}

#[test]
fn steps_run_at_the_same_time_and_leave_their_times() {
    let folder = tempfile::tempdir().unwrap();
    // Each waits for the other's file: one after the other they would wait for ever.
    let steps = "step_one() { touch one; until [ -e two ]; do sleep 0.05; done; echo met two; }\n\
                 step_two() { touch two; until [ -e one ]; do sleep 0.05; done; }\n";
    let output = ran(folder.path(), steps, "'one:' 'two:'");
    assert!(output.status.success(), "{}", said(&output));
    assert!(said(&output).contains("one      | met two"), "{}", said(&output));
    assert!(said(&output).contains("all\n"), "{}", said(&output));
    for name in ["one", "two"] {
        let times = std::fs::read_to_string(folder.path().join(format!("target/steps/{name}.times"))).unwrap();
        assert_eq!(times.lines().count(), 3, "{times}");
        assert!(times.lines().next().unwrap().parse::<f64>().unwrap() > 0.0, "{times}");
    }
}

#[test]
fn a_step_begins_when_those_that_it_needs_have_ended() {
    let folder = tempfile::tempdir().unwrap();
    let steps = "step_late() { cat first second; }\nstep_first() { sleep 0.3; echo 1 >first; }\nstep_second() { echo 2 >second; }\n";
    let output = ran(folder.path(), steps, "'late: first second' 'first:' 'second:'");
    assert!(output.status.success(), "{}", said(&output));
    assert!(said(&output).contains("late     | 1\nlate     | 2\n"), "{}", said(&output));
}

#[test]
fn the_first_failure_ends_the_others_and_says_how_to_run_it_again() {
    let folder = tempfile::tempdir().unwrap();
    let steps = "step_long() { sleep 600; touch outlived; }\nstep_bad() { echo of no use; false; echo not seen; }\nstep_after() { touch after; }\n";
    let begun = std::time::Instant::now();
    let output = ran(folder.path(), steps, "'long:' 'bad:' 'after: bad'");
    assert_eq!(output.status.code(), Some(1), "{}", said(&output));
    assert!(begun.elapsed().as_secs() < 300, "the other step was ended");
    let said = said(&output);
    assert!(said.contains("== failed: bad") && said.contains("again: ./test.sh step bad"), "{said}");
    assert!(said.contains("bad      | of no use") && !said.contains("not seen") && !said.contains("all\n"), "{said}");
    assert!(!folder.path().join("after").exists() && !folder.path().join("outlived").exists());
}

#[test]
fn an_unknown_step_is_refused_with_the_known_ones() {
    let folder = tempfile::tempdir().unwrap();
    let output = script(folder.path(), "step_one() { :; }\n", "'one:'").args(["step", "none"]).output().unwrap();
    assert_eq!(output.status.code(), Some(2));
    assert!(said(&output).contains("there is no step \"none\"; steps: one"), "{}", said(&output));
}

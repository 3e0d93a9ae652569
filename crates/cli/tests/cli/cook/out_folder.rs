//! `--out DIR` without permission or space, and with files of an earlier cook.

use std::path::Path;

use crate::running::{SHORT, names_in, run, saute};

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

/// Starts a cook of many minutes and waits until its output folder is locked.
#[cfg(target_os = "linux")]
fn long_cook(dir: &Path, out: &Path) -> std::process::Child {
    let recipe = dir.join("long.toml");
    let text = SHORT.replace("max_s = 100", "max_s = 86000").replacen("after_s = 10", "after_s = 80000", 1);
    std::fs::write(&recipe, text).unwrap();
    let child = saute()
        .args(["cook", recipe.to_str().unwrap(), "--out", out.to_str().unwrap()])
        .stdout(std::process::Stdio::piped())
        .stderr(std::process::Stdio::piped())
        .spawn()
        .unwrap();
    let start = std::time::Instant::now();
    while !out.join(".saute-unfinished-files").exists() {
        assert!(start.elapsed().as_secs() < 60, "the cook does not start");
        std::thread::sleep(std::time::Duration::from_millis(20));
    }
    // The lock is taken before the folder of the files is made; the signals are watched right after.
    std::thread::sleep(std::time::Duration::from_millis(500));
    child
}

#[cfg(target_os = "linux")]
fn signal(child: &std::process::Child, name: &str) {
    let sent = std::process::Command::new("kill").args([name, &child.id().to_string()]).status().unwrap();
    assert!(sent.success());
}

#[cfg(target_os = "linux")]
#[test]
fn of_two_programs_that_write_to_one_folder_the_second_says_so_and_leaves_the_first_alone() {
    let dir = tempfile::tempdir().unwrap();
    let out = dir.path().join("out");
    let mut first = long_cook(dir.path(), &out);
    let second = run(&["cook", &short(dir.path()), "--out", out.to_str().unwrap()]);
    assert_eq!((second.code, second.out.as_str()), (Some(2), ""));
    assert!(second.err.contains("another program is writing there") && second.err.contains("remedy"), "{}", second.err);
    assert!(first.try_wait().unwrap().is_none() && out.join(".saute-unfinished-files").exists());
    first.kill().unwrap();
    first.wait().unwrap();
}

#[cfg(target_os = "linux")]
#[test]
fn two_programs_at_once_leave_the_whole_results_of_one() {
    let dir = tempfile::tempdir().unwrap();
    let out = dir.path().join("out");
    let recipe = short(dir.path());
    for _ in 0..3 {
        let start = |_| {
            let args = ["cook", recipe.as_str(), "--out", out.to_str().unwrap()];
            saute().args(args).stderr(std::process::Stdio::piped()).stdout(std::process::Stdio::null()).spawn().unwrap()
        };
        let children: Vec<_> = (0..4).map(start).collect();
        let outputs: Vec<_> = children.into_iter().map(|c| c.wait_with_output().unwrap()).collect();
        let won = outputs.iter().filter(|o| o.status.success()).count();
        assert!(won >= 1, "{outputs:?}");
        for lost in outputs.iter().filter(|o| !o.status.success()) {
            assert!(String::from_utf8_lossy(&lost.stderr).contains("another program is writing"), "{lost:?}");
        }
        let names = names_in(&out);
        assert!(names.contains(&"report.html".to_owned()) && names.iter().all(|n| !n.starts_with('.')), "{names:?}");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn an_interrupted_cook_says_what_it_left() {
    for (name, is_new) in [("-INT", true), ("-TERM", false)] {
        let dir = tempfile::tempdir().unwrap();
        let out = dir.path().join("out");
        if !is_new {
            std::fs::create_dir(&out).unwrap();
            std::fs::write(out.join("report.html"), "old").unwrap();
        }
        let child = long_cook(dir.path(), &out);
        signal(&child, name);
        let ended = child.wait_with_output().unwrap();
        let err = String::from_utf8_lossy(&ended.stderr);
        assert_eq!(ended.status.code(), Some(130), "{err}");
        assert!(err.contains("interrupted at") && err.contains("nothing was written"), "{err}");
        let names = names_in(&out);
        assert_eq!(names, if is_new { Vec::new() } else { vec!["report.html".to_owned()] });
        assert_eq!(out.exists(), !is_new);
    }
}

#[cfg(target_os = "linux")]
#[test]
fn what_a_killed_cook_has_left_is_removed_by_the_next_one() {
    let dir = tempfile::tempdir().unwrap();
    let out = dir.path().join("out");
    let mut child = long_cook(dir.path(), &out);
    child.kill().unwrap();
    child.wait().unwrap();
    assert!(names_in(&out).iter().any(|n| n.starts_with('.')));
    let ran = run(&["cook", &short(dir.path()), "--out", out.to_str().unwrap()]);
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    assert!(names_in(&out).iter().all(|n| !n.starts_with('.')), "{:?}", names_in(&out));
}

//! Recipes with mistakes: place, message and remedy; exit code 2; nothing is written.

use std::path::Path;

use crate::running::{Ran, SHORT, run};

/// A mistake in a recipe: the text and its replacement, the line in the message, and parts of the message.
struct Wrong {
    from: &'static str,
    to: &'static str,
    line: usize,
    says: &'static [&'static str],
}

const fn wrong(from: &'static str, to: &'static str, line: usize, says: &'static [&'static str]) -> Wrong {
    Wrong { from, to, line, says }
}

const WRONG: [Wrong; 29] = [
    wrong("max_s = 100", "max_seconds = 100", 2, &["max_seconds is no key", "there are: food, hob, max_s"]),
    wrong("initial_c = 180", "initial = 180", 5, &["initial", "initial_c"]),
    wrong("flip = \"steak\"", "flop = \"steak\"", 17, &["flop", "flip"]),
    wrong("kind = \"beef-lean\"", "kind = \"beef\"", 8, &["beef", "beef-lean, beef-marbled"]),
    wrong("kind = \"carbon-steel-26\"", "kind = \"wok\"", 4, &["wok", "carbon-steel-26"]),
    wrong("[60, 50, 15]", "[60, -50, 15]", 9, &["width", "-50", "30 to 190 mm"]),
    wrong("[60, 50, 15]", "[60, 50, 0.001]", 9, &["thickness", "10 to 60 mm"]),
    wrong("[60, 50, 15]", "[60e9, 50, 15]", 9, &["length", "30 to 190 mm"]),
    wrong("[60, 50, 15]", "[nan, 50, 15]", 9, &["size_mm = NaN", "a finite number"]),
    wrong("[60, 50, 15]", "[60, 50]", 9, &["three numbers"]),
    wrong("initial_c = 5\n", "initial_c = -300\n", 10, &["initial_c", "-25 to 60"]),
    wrong("hob_w = 1100", "hob_w = 9000", 12, &["hob_w", "0 to 3500"]),
    wrong("hob_w = 1100", "hob_w = -1", 12, &["hob_w", "0 to 3500"]),
    wrong("hob_w = 1100", "hob_w = \"high\"", 12, &["hob_w is a text", "a number or a table"]),
    wrong("flip = \"steak\"", "flip = \"chop\"", 17, &["chop", "names no food", "steak"]),
    wrong("put = \"steak\"", "put = \"\"", 14, &["names no food", "steak"]),
    wrong("put = \"steak\"", "put = true", 14, &["must be a text or a table"]),
    wrong("put = \"steak\"", "", 13, &["no action", "hob_w, put, flip"]),
    wrong("put = \"steak\"", "put = \"steak\"\nhob_w = 0", 13, &["more than one action"]),
    wrong("after_s = 10\nflip", "after_s = 10\nat_s = 20\nflip", 15, &["more than one trigger"]),
    wrong("after_s = 10\nflip", "when = { core_c = 20 }\nflip", 16, &["when needs one condition", "food = \"steak\""]),
    wrong("after_s = 10\nflip", "when = { pan_c = { over = 20 } }\nflip", 16, &["over", "above"]),
    wrong("hob_w = 1100", "hob_w = { hold_c = 300, w = 2000 }", 12, &["hob_w.hold_c", "50 to 230"]),
    wrong("flip = \"steak\"", "repeat = { flip = \"steak\", every_s = 0, times = 2 }", 17, &["every_s", "0.1 to 3600"]),
    wrong(
        "flip = \"steak\"",
        "repeat = { flip = \"steak\", every_s = 5 }",
        17,
        &["neither until nor times", "times = 8"],
    ),
    wrong("after_s = 10\nend = true\n", "after_s = 10\nhob_w = 0\n", 20, &["no end", "end = true"]),
    wrong("put = \"steak\"", "flip = \"steak\"", 13, &["not in the pan", "put it into the pan"]),
    wrong("after_s = 10\nend", "at_s = 3\nend", 18, &["at_s = 3 is already past", "later at_s"]),
    wrong("[[step]]\nhob_w", "[[step]\nhob_w", 11, &["remedy"]),
];

/// Cooks a file that must be refused: nothing is printed to stdout or written.
fn refused(path: &Path) -> Ran {
    let out = path.with_extension("out");
    let ran = run(&["cook", path.to_str().unwrap(), "--json", "--out", out.to_str().unwrap()]);
    assert_eq!((ran.code, ran.out.as_str()), (Some(2), ""), "{}", ran.err);
    assert!(ran.err.contains(path.to_str().unwrap()) && ran.err.contains("remedy:"), "{}", ran.err);
    assert!(!out.exists(), "something was written");
    ran
}

#[test]
fn every_mistake_in_a_recipe_is_named_with_file_line_and_remedy() {
    let dir = tempfile::tempdir().unwrap();
    for (index, w) in WRONG.iter().enumerate() {
        let path = dir.path().join(format!("wrong-{index}.toml"));
        assert!(SHORT.contains(w.from), "{}", w.from);
        std::fs::write(&path, SHORT.replacen(w.from, w.to, 1)).unwrap();
        let ran = refused(&path);
        assert!(
            ran.err.contains(&format!("{}:{}:", path.display(), w.line)),
            "line {} of {:?}:\n{}",
            w.line,
            w.to,
            ran.err
        );
        for part in w.says {
            assert!(ran.err.contains(part), "{part}:\n{}", ran.err);
        }
    }
}

#[test]
fn a_time_that_has_passed_when_its_step_comes_up_is_named_with_file_line_and_remedy() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("late.toml");
    std::fs::write(
        &path,
        SHORT.replace("put = \"steak\"", "when = { pan_c = 185 }\nput = \"steak\"\n[[step]]\nat_s = 0.5\nhob_w = 0"),
    )
    .unwrap();
    let ran = refused(&path);
    assert!(ran.err.contains("late.toml:16:") && ran.err.contains("already past"), "{}", ran.err);
}

#[test]
fn files_that_are_no_recipes_are_refused() {
    let dir = tempfile::tempdir().unwrap();
    let cases: [(&str, &[u8], &str); 3] = [
        ("empty.toml", b"", "empty.toml:1: the file is empty"),
        ("blank.toml", b" \n\n", "blank.toml:1: the file is empty"),
        ("latin.toml", b"title = 'x'\n# caf\xe9\n", "latin.toml:2: is not UTF-8 text"),
    ];
    for (name, bytes, message) in cases {
        let path = dir.path().join(name);
        std::fs::write(&path, bytes).unwrap();
        let ran = refused(&path);
        assert!(ran.err.contains(message), "{}", ran.err);
    }
}

#[test]
fn missing_files_and_folders_are_refused() {
    let dir = tempfile::tempdir().unwrap();
    let ran = refused(&dir.path().join("missing.toml"));
    assert!(ran.err.contains("no such file") && ran.err.contains("medium"), "{}", ran.err);
    let folder = dir.path().join("folder");
    std::fs::create_dir(&folder).unwrap();
    assert!(refused(&folder).err.contains("is a folder"));
}

#[cfg(target_os = "linux")]
#[test]
fn a_file_without_end_is_refused_instead_of_filling_the_memory() {
    let ran = run(&["cook", "/dev/zero"]);
    assert!(ran.code == Some(2) && ran.err.contains("is a pipe or a device"), "{}", ran.err);
}

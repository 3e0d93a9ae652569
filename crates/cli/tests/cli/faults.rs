//! Promise: the faults that `scripts/faults.sh` puts in by hand still fit the code: a fault whose text was moved tests nothing.

use std::path::Path;

/// Words of a command of a shell: bare, or in quotes, which may go over lines; a backslash before the end of a line is space.
fn words(command: &str) -> Vec<String> {
    let mut words = Vec::new();
    let mut rest = command.trim_start();
    while let Some(first) = rest.chars().next().filter(|first| *first != '\n') {
        let (word, after) = match first {
            '"' | '\'' => rest[1..].split_once(first).expect("a closing quote"),
            _ => rest.split_at(rest.find(char::is_whitespace).unwrap_or(rest.len())),
        };
        if word != "\\" {
            words.push(word.to_owned());
        }
        let is_continued = word == "\\";
        rest = if is_continued { after.trim_start() } else { after.trim_start_matches(' ') };
    }
    words
}

#[test]
fn every_fault_changes_a_text_that_is_there_once_and_names_a_program_of_tests() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let script = std::fs::read_to_string(root.join("scripts/faults.sh")).unwrap();
    let mut found = 0;
    for (at, _) in script.match_indices("\nfault \"") {
        let words = words(&script[at + 1..]);
        let [_, what, file, from, _, kind, program, ..] = words.as_slice() else { panic!("{words:?}") };
        let text = std::fs::read_to_string(root.join(file)).unwrap_or_else(|error| panic!("{what}: {file}: {error}"));
        assert_eq!(text.matches(from.as_str()).count(), 1, "{what}: {file} has not once: {from}");
        let crates = std::fs::read_dir(root.join("crates")).unwrap().map(|entry| entry.unwrap().path());
        let has_it = |folder: std::path::PathBuf| folder.join("tests").join(program).exists();
        assert!(kind == "unit" || crates.into_iter().any(has_it), "{what}: there is no program {program}");
        found += 1;
    }
    assert_eq!(found, 10);
}

#[test]
fn words_of_a_shell_are_read_over_lines() {
    let read = words("fault \"what is it\" a/b.rs \\\n    'one\n  two;' '' \\\n    integration x ''\nnext");
    assert_eq!(read, ["fault", "what is it", "a/b.rs", "one\n  two;", "", "integration", "x", ""]);
}

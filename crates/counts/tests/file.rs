//! Promise: the file of counts names exactly the work that is counted.

use std::collections::BTreeSet;
use std::path::Path;
use std::process::Command;

#[test]
fn each_piece_of_work_has_its_count_in_the_file_and_the_file_has_no_other() {
    let listed = Command::new(env!("CARGO_BIN_EXE_saute-counts")).output().expect("runs").stdout;
    let work: BTreeSet<String> = String::from_utf8(listed).expect("text").lines().map(str::to_owned).collect();
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scripts/counts.toml");
    let text = std::fs::read_to_string(file).expect("scripts/counts.toml");
    let (_, counts) = text.split_once("[instructions]\n").expect("a table of instructions");
    let counted: BTreeSet<String> =
        counts.lines().filter_map(|line| line.split_once(" = ")).map(|(name, _)| name.to_owned()).collect();
    assert_eq!(work, counted);
    assert!(!work.is_empty());
}

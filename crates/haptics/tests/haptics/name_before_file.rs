//! Promise: a file with the name of a networked device does not hide the device. A separate process, because it changes the folder.

use std::process::Command;

use saute_haptics::Named;

#[test]
#[ignore = "the program that the other test starts in a folder with such a file"]
fn program_in_a_folder() {
    assert!(Named::parse("phone").unwrap().geometry().is_none());
    assert!(Named::parse("./phone").is_err(), "a path names the file, which is not a geometry");
}

#[test]
fn a_file_with_the_name_of_a_networked_device_does_not_hide_it() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("phone"), "numbers of a friend").unwrap();
    let mut program = Command::new(std::env::current_exe().unwrap());
    program.args(["--ignored", "--exact", "name_before_file::program_in_a_folder"]).current_dir(folder.path());
    let output = program.output().unwrap();
    let said = String::from_utf8_lossy(&output.stdout);
    assert!(output.status.success() && said.contains("1 passed"), "{said}");
}

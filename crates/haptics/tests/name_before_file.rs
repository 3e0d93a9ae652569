//! Promise: a file with the name of a networked device does not hide the device. A process of its own, because it changes the folder.

// A failed unwrap in a test names its line.
#![allow(clippy::unwrap_used)]

use saute_haptics::Named;

#[test]
fn a_file_with_the_name_of_a_networked_device_does_not_hide_it() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("phone"), "numbers of a friend").unwrap();
    std::env::set_current_dir(folder.path()).unwrap();
    assert!(Named::parse("phone").unwrap().geometry().is_none());
    assert!(Named::parse("./phone").is_err(), "a path names the file, which is not a geometry");
}

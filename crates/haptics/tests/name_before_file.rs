//! Promise: a file that is called like a networked device does not hide it. A process of its own, for it changes the folder.

// A test that unwraps in vain says where.
#![allow(clippy::unwrap_used)]

use saute_haptics::Named;

#[test]
fn a_file_called_like_a_networked_device_does_not_hide_it() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("phone"), "numbers of a friend").unwrap();
    std::env::set_current_dir(folder.path()).unwrap();
    assert!(Named::parse("phone").unwrap().geometry().is_none());
    assert!(Named::parse("./phone").is_err(), "a file is meant, and it is no geometry");
}

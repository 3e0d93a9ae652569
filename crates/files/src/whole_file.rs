//! One file that is there as a whole or not at all.

use std::fs::{self, File};
use std::io::{self, Write};
use std::path::Path;

use crate::regular_file;

/// Writes a file; what was at its path stays until all bytes are on the disk. The part is written next to it. A link is followed, so that
/// the file behind it is replaced and not the link.
///
/// # Errors
///
/// If it cannot be written; the part is removed then.
pub fn write_whole(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let path = &path.canonicalize().unwrap_or_else(|_| path.to_owned());
    let mut name = path.file_name().ok_or(io::ErrorKind::InvalidInput)?.to_owned();
    name.push(format!(".{}.part", std::process::id()));
    write_by_way_of(&path.with_file_name(name), path, bytes)
}

/// Writes a file as [`write_whole`] does, with a part at a path of the caller's on the same disk.
///
/// # Errors
///
/// As of [`write_whole`], and if something else than a file is where the part is to be.
pub fn write_by_way_of(part: &Path, path: &Path, bytes: &[u8]) -> io::Result<()> {
    regular_file::check_place(part)?;
    let written = write_synced(part, bytes).and_then(|()| fs::rename(part, path));
    if written.is_err() {
        // What could not be written is of no use; the error that is returned states why.
        let _ = fs::remove_file(part);
    }
    written
}

/// Writes a file and waits until it is on the disk.
pub(crate) fn write_synced(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let mut file = File::create(path)?;
    file.write_all(bytes)?;
    file.sync_all()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_that_cannot_get_its_name_leaves_nothing_and_the_old_one_as_it_was() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("report");
        fs::create_dir(&path).expect("a folder of that name");
        fs::write(path.join("inside"), "old").expect("writes");
        assert!(write_whole(&path, b"new").is_err());
        assert_eq!(fs::read_dir(folder.path()).expect("lists").count(), 1, "no part is left");
        assert_eq!(fs::read_to_string(path.join("inside")).expect("reads"), "old");
        let path = folder.path().join("other");
        for text in ["first", "second"] {
            write_whole(&path, text.as_bytes()).expect("writes");
            assert_eq!(fs::read_to_string(&path).expect("reads"), text);
        }
        assert_eq!(fs::read_dir(folder.path()).expect("lists").count(), 2, "no part is left");
    }

    #[cfg(unix)]
    #[test]
    fn a_link_stays_and_the_file_behind_it_is_replaced() {
        let folder = tempfile::tempdir().expect("a folder");
        let [behind, link] = ["behind", "link"].map(|name| folder.path().join(name));
        fs::write(&behind, "old").expect("writes");
        std::os::unix::fs::symlink(&behind, &link).expect("links");
        write_whole(&link, b"new").expect("writes");
        assert!(link.symlink_metadata().expect("is there").is_symlink());
        assert_eq!(fs::read_to_string(&behind).expect("reads"), "new");
    }
}

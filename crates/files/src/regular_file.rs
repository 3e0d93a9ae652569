//! Files that people name, read whole and within a limit.

use std::fs::File;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

/// Why a file is not read.
#[derive(Debug, thiserror::Error)]
pub enum Unread {
    /// It is a folder.
    #[error("is a folder, not a file")]
    Folder,
    /// It is a pipe, a device or a socket.
    #[error("is a pipe or a device, not a file")]
    NoFile,
    /// It is larger than so many MiB.
    #[error("is larger than {0} MiB")]
    Large(u64),
    /// The system does not give it.
    #[error("cannot be read: {0}")]
    Io(#[from] io::Error),
    /// It is no text.
    #[error("is not UTF-8 text")]
    NoText,
}

impl Unread {
    /// Returns true if there is nothing of that name.
    pub fn is_missing(&self) -> bool {
        matches!(self, Self::Io(error) if error.kind() == io::ErrorKind::NotFound)
    }
}

/// Reads a file of at most so many MiB.
///
/// # Errors
///
/// If it is no regular file: a pipe or a device could block where it is opened, or have no end. If it is larger, or cannot be read.
pub fn read(path: &Path, largest_mib: u64) -> Result<Vec<u8>, Unread> {
    check(path)?;
    let mut bytes = Vec::new();
    let largest = largest_mib << 20;
    File::open(path)?.take(largest + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > largest { Err(Unread::Large(largest_mib)) } else { Ok(bytes) }
}

/// Reads a text as [`read`] does.
///
/// # Errors
///
/// As of [`read`], and if it is not UTF-8.
pub fn read_text(path: &Path, largest_mib: u64) -> Result<String, Unread> {
    String::from_utf8(read(path, largest_mib)?).map_err(|_| Unread::NoText)
}

/// Refuses what is no regular file, without opening it.
///
/// # Errors
///
/// If it is none, or is not there.
pub fn check(path: &Path) -> Result<(), Unread> {
    let about = path.metadata()?;
    match about.is_file() {
        true => Ok(()),
        false if about.is_dir() => Err(Unread::Folder),
        false => Err(Unread::NoFile),
    }
}

/// Refuses a place to write to where something else than a regular file is; a place where nothing is yet is free.
///
/// # Errors
///
/// If there is something else.
pub fn check_place(path: &Path) -> io::Result<()> {
    match check(path) {
        Err(Unread::Io(error)) if error.kind() != io::ErrorKind::NotFound => Err(error),
        Ok(()) | Err(Unread::Io(_)) => Ok(()),
        Err(unread) => Err(io::Error::other(unread)),
    }
}

/// Reads a file that another file names, from its folder; none if it is not there, is too large, or a link leads out of the folder.
pub fn read_beside(path: &Path, name: &str, largest_mib: u64) -> Option<Vec<u8>> {
    let file = path.with_file_name(name);
    match led_out(path.parent()?, &file) {
        Some(_) => None,
        None => read(&file, largest_mib).ok(),
    }
}

/// Returns where a path leads out of a folder, by a link to another place; none if it does not, or cannot be followed.
pub fn led_out(folder: &Path, path: &Path) -> Option<PathBuf> {
    // The parent of a plain name is empty, and means the working folder.
    let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
    let (folder, file) = (folder.canonicalize().ok()?, path.canonicalize().ok()?);
    (!file.starts_with(folder)).then_some(file)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A new empty folder.
    fn folder(name: &str) -> PathBuf {
        let folder = std::env::temp_dir().join(format!("saute-regular-file-{name}-{}", std::process::id()));
        let _ = std::fs::remove_dir_all(&folder);
        std::fs::create_dir_all(&folder).expect("a folder");
        folder
    }

    #[test]
    fn a_file_is_read_up_to_its_limit_and_a_larger_one_is_refused() {
        let folder = folder("large");
        let path = folder.join("file");
        std::fs::write(&path, vec![b'a'; 1 << 20]).expect("writes");
        assert_eq!(read(&path, 1).expect("fits").len(), 1 << 20);
        std::fs::write(&path, vec![b'a'; (1 << 20) + 1]).expect("writes");
        assert_eq!(read(&path, 1).expect_err("too large").to_string(), "is larger than 1 MiB");
        std::fs::write(&path, [0xff]).expect("writes");
        assert_eq!(read_text(&path, 1).expect_err("no text").to_string(), "is not UTF-8 text");
        assert!(read(&folder.join("none"), 1).expect_err("is not there").is_missing());
        assert!(matches!(read(&folder, 1), Err(Unread::Folder)));
        std::fs::remove_dir_all(folder).expect("removes");
    }

    #[cfg(unix)]
    #[test]
    fn a_device_without_an_end_is_refused_before_it_is_opened() {
        assert!(matches!(read(Path::new("/dev/zero"), 1), Err(Unread::NoFile)));
        let refused = check_place(Path::new("/dev/zero")).expect_err("is no file");
        assert_eq!(refused.to_string(), "is a pipe or a device, not a file");
        assert!(check_place(Path::new("/nowhere/at/all")).is_ok());
    }

    #[cfg(unix)]
    #[test]
    fn a_link_out_of_a_folder_is_told_from_one_within() {
        let folder = folder("links");
        std::fs::create_dir(folder.join("data")).expect("a folder");
        let (inside, link) = (folder.join("data/a"), folder.join("data/b"));
        std::fs::write(folder.join("outside"), "x").expect("writes");
        std::fs::write(&inside, "x").expect("writes");
        std::os::unix::fs::symlink("../outside", &link).expect("links");
        assert_eq!(led_out(&folder.join("data"), &inside), None);
        assert!(led_out(&folder.join("data"), &link).is_some_and(|place| place.ends_with("outside")));
        assert_eq!(led_out(&folder, &link), None);
        assert!(led_out(Path::new(""), &link).is_some(), "the working folder is another one");
        assert_eq!(read_beside(&inside, "b", 1), None);
        assert_eq!(read_beside(&link, "a", 1), Some(b"x".to_vec()));
        std::fs::remove_dir_all(folder).expect("removes");
    }
}

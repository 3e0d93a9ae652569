//! A locked file: two programs do not write to one place at the same time. The system releases the lock of a dead process.

use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

/// Attempts to lock a file that another process keeps replacing (chosen: one replacement at a time is usual).
const ATTEMPTS: usize = 10;

/// Message if another program holds a lock.
const HELD: &str = "another program is writing there";

/// A locked file, which is removed on drop unless it was renamed.
#[derive(Debug)]
pub struct LockedFile {
    path: PathBuf,
    file: File,
    is_renamed: bool,
}

impl LockedFile {
    /// Creates a file if there is none, and locks it; its content stays as it is.
    ///
    /// # Errors
    ///
    /// [`ErrorKind::ResourceBusy`] if another process holds the lock.
    pub fn take(path: &Path) -> io::Result<Self> {
        for _ in 0..ATTEMPTS {
            let file = OpenOptions::new().write(true).create(true).truncate(false).open(path)?;
            lock(&file)?;
            // The process that held the lock before may have removed or renamed the file since it was opened here.
            if is_still_at(&file, path)? {
                return Ok(Self { path: path.to_owned(), file, is_renamed: false });
            }
        }
        Err(held())
    }

    /// Returns the locked file.
    pub fn file(&mut self) -> &mut File {
        &mut self.file
    }

    /// Gives the locked file another name.
    pub fn rename(mut self, to: &Path) -> io::Result<()> {
        fs::rename(&self.path, to)?;
        self.is_renamed = true;
        Ok(())
    }
}

impl Drop for LockedFile {
    fn drop(&mut self) {
        if !self.is_renamed {
            // Removed before the lock is released, so that it is surely the own file.
            let _ = fs::remove_file(&self.path);
        }
    }
}

/// Locks an open file until it is closed.
///
/// # Errors
///
/// [`ErrorKind::ResourceBusy`] if another process holds the lock.
pub fn lock(file: &File) -> io::Result<()> {
    match file.try_lock() {
        Ok(()) => Ok(()),
        Err(TryLockError::WouldBlock) => Err(held()),
        // Some network file systems have no locks: there the last program to finish wins.
        Err(TryLockError::Error(e)) if e.kind() == ErrorKind::Unsupported => Ok(()),
        Err(TryLockError::Error(e)) => Err(e),
    }
}

fn held() -> io::Error {
    io::Error::new(ErrorKind::ResourceBusy, HELD)
}

/// Returns true if the file at a path is an open file.
#[cfg(unix)]
fn is_still_at(file: &File, path: &Path) -> io::Result<bool> {
    use std::os::unix::fs::MetadataExt;
    let open = file.metadata()?;
    match fs::metadata(path) {
        Ok(there) => Ok((there.dev(), there.ino()) == (open.dev(), open.ino())),
        Err(e) if e.kind() == ErrorKind::NotFound => Ok(false),
        Err(e) => Err(e),
    }
}

/// Returns true: other systems do not remove a file that is open.
#[cfg(not(unix))]
fn is_still_at(_: &File, _: &Path) -> io::Result<bool> {
    Ok(true)
}

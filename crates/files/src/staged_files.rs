//! Files that change places together: written into a separate folder first, then given their final names.
//!
//! A mark states that all of them are complete. If the program is killed after that, the next run gives the rest their names;
//! before it, the next run removes them.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use crate::locked_file::LockedFile;
use crate::whole_file::write_synced;

/// Folder of the files without their final names.
const STAGE: &str = ".saute-unfinished-files";
/// Beginning of the names of everything that is unfinished.
const UNFINISHED: &str = ".saute-unfinished-";
/// File that lists the names of complete files, one a line.
const MARK: &str = "complete";

/// Which files of a run are of a sort that needs an order.
#[derive(Clone, Copy, Debug)]
pub struct Sorts {
    /// Returns true for a page, which refers to the other files.
    pub is_page: fn(&str) -> bool,
    /// Returns true for a file of which another run may have had more.
    pub is_numbered: fn(&str) -> bool,
}

/// The files of one run, on their way into a folder.
#[derive(Debug)]
pub struct StagedFiles {
    folder: PathBuf,
    stage: PathBuf,
    sorts: Sorts,
}

impl StagedFiles {
    /// Clears what a dead process has left in a folder, and makes the folder for the files of this run.
    ///
    /// The caller holds the folder's lock, named `lock`.
    pub fn begin(folder: &Path, lock: &str, sorts: Sorts) -> io::Result<Self> {
        let staged = Self { folder: folder.to_owned(), stage: folder.join(STAGE), sorts };
        if let Ok(names) = staged.complete() {
            // What cannot get its name now never will: it is removed below.
            let _ = staged.publish(&names);
        }
        for entry in fs::read_dir(folder)? {
            let entry = entry?;
            let is_left = entry.file_name().to_str().is_some_and(|name| name.starts_with(UNFINISHED) && name != lock);
            match entry.file_type()? {
                kind if is_left && kind.is_dir() => fs::remove_dir_all(entry.path())?,
                // A file that another program writes now is locked; the lock of another one is taken, and removes the file.
                kind if is_left && kind.is_file() => drop(LockedFile::take(&entry.path()).ok()),
                _ => {}
            }
        }
        fs::create_dir(&staged.stage)?;
        Ok(staged)
    }

    /// Writes a file and waits until it is on the disk.
    pub fn write(&self, name: &str, bytes: &[u8]) -> io::Result<()> {
        write_synced(&self.stage.join(name), bytes)
    }

    /// Removes a written file.
    pub fn remove(&self, name: &str) -> io::Result<()> {
        fs::remove_file(self.stage.join(name))
    }

    /// Gives all written files their final names.
    pub fn finish(&self, names: &[&str]) -> io::Result<()> {
        if let Some(taken) = names.iter().find(|name| self.folder.join(name).is_dir()) {
            return Err(io::Error::other(format!("{taken} is a folder")));
        }
        self.write(MARK, names.join("\n").as_bytes())?;
        self.publish(names)
    }

    /// Returns the names of the complete files of a dead process.
    fn complete(&self) -> io::Result<Vec<String>> {
        let text = fs::read_to_string(self.stage.join(MARK))?;
        // A name leads into no other folder.
        Ok(text.lines().filter(|name| !name.contains(['/', '\\']) && *name != "..").map(str::to_owned).collect())
    }

    /// Removes the old pages and numbered files, then gives the others their names, and the pages last: no page is ever next to files of
    /// another run.
    fn publish<N: AsRef<str>>(&self, names: &[N]) -> io::Result<()> {
        let (pages, others): (Vec<&str>, Vec<&str>) = names
            .iter()
            .map(AsRef::as_ref)
            .filter(|name| self.stage.join(name).is_file())
            .partition(|n| (self.sorts.is_page)(n));
        for page in &pages {
            fs::remove_file(self.folder.join(page)).or_else(|e| match e.kind() {
                io::ErrorKind::NotFound => Ok(()),
                _ => Err(e),
            })?;
        }
        self.clear_old(names)?;
        let mut in_order = others.iter().chain(&pages);
        in_order.try_for_each(|name| fs::rename(self.stage.join(name), self.folder.join(name)))
    }

    /// Removes the numbered files of an earlier run, which may have been longer.
    fn clear_old<N: AsRef<str>>(&self, names: &[N]) -> io::Result<()> {
        for entry in fs::read_dir(&self.folder)? {
            let entry = entry?;
            let is_old = |name: &str| (self.sorts.is_numbered)(name) && !names.iter().any(|new| new.as_ref() == name);
            if entry.file_name().to_str().is_some_and(is_old) {
                fs::remove_file(entry.path())?;
            }
        }
        Ok(())
    }
}

impl Drop for StagedFiles {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.stage);
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    const SORTS: Sorts =
        Sorts { is_page: |name| name.ends_with(".html"), is_numbered: |name| name.starts_with("part_") };

    /// What a process that was killed at some moment has left.
    fn killed(folder: &Path, is_complete: bool) {
        let stage = folder.join(STAGE);
        fs::create_dir(&stage).unwrap();
        for (name, text) in [("report.html", "new"), ("picture.png", "new"), ("half.png", "half")] {
            fs::write(stage.join(name), text).unwrap();
        }
        fs::write(folder.join("report.html"), "old").unwrap();
        fs::write(folder.join(".saute-unfinished-old.png"), "half").unwrap();
        if is_complete {
            fs::write(stage.join(MARK), "report.html\npicture.png\n../outside").unwrap();
        }
    }

    #[test]
    fn the_files_of_a_killed_process_get_their_names_if_they_are_complete_and_are_removed_else() {
        for is_complete in [true, false] {
            let dir = tempfile::tempdir().unwrap();
            killed(dir.path(), is_complete);
            drop(StagedFiles::begin(dir.path(), "lock", SORTS).unwrap());
            let mut names: Vec<_> = fs::read_dir(dir.path()).unwrap().map(|e| e.unwrap().file_name()).collect();
            names.sort();
            let expected: &[&str] = if is_complete { &["picture.png", "report.html"] } else { &["report.html"] };
            assert_eq!(names, expected);
            let page = fs::read_to_string(dir.path().join("report.html")).unwrap();
            assert_eq!(page, if is_complete { "new" } else { "old" });
        }
    }

    #[test]
    fn a_page_that_cannot_change_places_with_its_pictures_does_not_stand_beside_them() {
        let dir = tempfile::tempdir().unwrap();
        fs::write(dir.path().join("report.html"), "old").unwrap();
        fs::create_dir(dir.path().join("picture.png")).unwrap();
        let staged = StagedFiles::begin(dir.path(), "lock", SORTS).unwrap();
        staged.write("report.html", b"new").unwrap();
        staged.write("picture.png", b"new").unwrap();
        assert!(staged.finish(&["report.html", "picture.png"]).is_err());
        assert_eq!(fs::read_to_string(dir.path().join("report.html")).unwrap(), "old");
    }
}

//! Records one after the other in a file, as they come.
//!
//! A record is its length [bytes] and its hash, both as 8 bytes, least first, then its bytes. What a killed program has left of its last
//! record is cut off; so is all from the first damaged record on.

use std::fs::{File, OpenOptions};
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};

use crate::checksums::sum_of;
use crate::regular_file;

/// Bytes of a record before its own.
const HEAD: usize = 16;

/// A journal that is open for writing.
#[derive(Debug)]
pub struct Journal {
    path: PathBuf,
    file: File,
}

impl Journal {
    /// Opens a journal, and hands over the bytes of the records that are in it. The first one that `take` refuses counts as damaged.
    ///
    /// # Errors
    ///
    /// If something else than a file is there, or it cannot be read or cut.
    pub fn open(path: &Path, take: impl FnMut(&[u8]) -> bool) -> io::Result<Self> {
        regular_file::check_place(path)?;
        let mut file = OpenOptions::new().read(true).append(true).create(true).open(path)?;
        let mut bytes = Vec::new();
        file.read_to_end(&mut bytes)?;
        let sound = read(&bytes, take);
        if sound < bytes.len() {
            file.set_len(sound as u64)?;
        }
        Ok(Self { path: path.to_owned(), file })
    }

    /// Its file.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Adds a record.
    ///
    /// # Errors
    ///
    /// If it cannot be written.
    pub fn add(&mut self, own: &[u8]) -> io::Result<()> {
        let mut record = Vec::with_capacity(HEAD + own.len());
        record.extend((own.len() as u64).to_le_bytes());
        record.extend(sum_of(own).to_le_bytes());
        record.extend(own);
        self.file.write_all(&record)
    }
}

/// Hands over the sound records; returns their length [bytes].
fn read(bytes: &[u8], mut take: impl FnMut(&[u8]) -> bool) -> usize {
    let mut at = 0;
    while let Some(own) = record(bytes, at).filter(|own| take(own)) {
        at += HEAD + own.len();
    }
    at
}

/// Returns the bytes of the record at a place; none if there is no sound one.
fn record(bytes: &[u8], at: usize) -> Option<&[u8]> {
    let number = |at: usize| Some(u64::from_le_bytes(bytes.get(at..at + 8)?.try_into().ok()?));
    let length = usize::try_from(number(at)?).ok()?;
    let end = (at + HEAD).checked_add(length)?;
    let own = bytes.get(at + HEAD..end)?;
    (sum_of(own) == number(at + 8)?).then_some(own)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn opened(path: &Path) -> (Journal, Vec<Vec<u8>>) {
        let mut found = Vec::new();
        let journal = Journal::open(path, |own| {
            found.push(own.to_vec());
            own != b"refused"
        });
        (journal.expect("opens"), found)
    }

    fn three(path: &Path) -> Vec<u8> {
        let (mut journal, _) = opened(path);
        (0..3u8).for_each(|row| journal.add(&[row; 9]).expect("is written"));
        std::fs::read(path).expect("reads")
    }

    #[test]
    fn a_journal_that_is_cut_anywhere_keeps_every_whole_record_and_goes_on_behind_them() {
        let dir = tempfile::tempdir().expect("a folder");
        let path = dir.path().join("journal");
        let whole = three(&path);
        let length = whole.len() / 3;
        for cut in 0..=whole.len() {
            std::fs::write(&path, &whole[..cut]).expect("writes");
            let (mut journal, found) = opened(&path);
            assert_eq!(found.len(), cut / length, "cut at {cut}");
            assert!(found.iter().zip(0..).all(|(own, row)| *own == [row; 9]));
            journal.add(b"seven").expect("is written");
            assert_eq!(opened(&path).1.last().map(Vec::as_slice), Some(&b"seven"[..]));
        }
    }

    #[test]
    fn a_record_with_a_wrong_byte_or_that_is_refused_and_what_follows_it_is_cut_off() {
        let dir = tempfile::tempdir().expect("a folder");
        let path = dir.path().join("journal");
        let mut bytes = three(&path);
        let middle = bytes.len() / 2;
        bytes[middle] ^= 1;
        std::fs::write(&path, bytes).expect("writes");
        let (mut journal, found) = opened(&path);
        assert_eq!(found, [[0; 9]]);
        for own in [&b"refused"[..], b"lost"] {
            journal.add(own).expect("is written");
        }
        opened(&path);
        assert_eq!(opened(&path).1, [[0; 9]]);
    }
}

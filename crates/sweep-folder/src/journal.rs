//! The results of a part that is not complete, one after the other as they come.
//!
//! A record is the length of its result [bytes] and its hash, both as 8 bytes, least first, then the result. What a killed program has
//! left of its last record is cut off; so is all from the first damaged record on, whose rows are cooked again.

use std::collections::BTreeMap;
use std::fs::{File, OpenOptions};
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};

use saute_files::regular_file;
use saute_sweep::RowResult;

use crate::checksums::sum_of;

/// Bytes of a record before its result.
const HEAD: usize = 16;

/// A journal that is open for writing.
#[derive(Debug)]
pub(crate) struct Journal {
    pub(crate) path: PathBuf,
    file: File,
}

impl Journal {
    /// Opens the journal of a part; returns it with the results that are in it, by their rows.
    pub(crate) fn open(path: &Path) -> io::Result<(Self, BTreeMap<u64, RowResult>)> {
        regular_file::check_place(path)?;
        let mut file = OpenOptions::new().read(true).append(true).create(true).open(path)?;
        let mut bytes = Vec::new();
        file.read_to_end(&mut bytes)?;
        let (results, sound) = read(&bytes);
        if sound < bytes.len() {
            file.set_len(sound as u64)?;
        }
        Ok((Self { path: path.to_owned(), file }, results))
    }

    /// Adds a result.
    pub(crate) fn add(&mut self, result: &RowResult) -> io::Result<()> {
        let bytes = result.to_bytes();
        let mut record = Vec::with_capacity(HEAD + bytes.len());
        record.extend((bytes.len() as u64).to_le_bytes());
        record.extend(sum_of(&bytes).to_le_bytes());
        record.extend(bytes);
        self.file.write_all(&record)
    }
}

/// Returns the results of the sound records, and their length [bytes].
fn read(bytes: &[u8]) -> (BTreeMap<u64, RowResult>, usize) {
    let (mut results, mut at) = (BTreeMap::new(), 0);
    while let Some((result, next)) = record(bytes, at) {
        results.entry(result.row).or_insert(result);
        at = next;
    }
    (results, at)
}

/// Returns the result of the record at a place, and the place after it; none if there is no sound one.
fn record(bytes: &[u8], at: usize) -> Option<(RowResult, usize)> {
    let number = |at: usize| Some(u64::from_le_bytes(bytes.get(at..at + 8)?.try_into().ok()?));
    let length = usize::try_from(number(at)?).ok()?;
    let end = (at + HEAD).checked_add(length)?;
    let own = bytes.get(at + HEAD..end)?;
    if sum_of(own) != number(at + 8)? {
        return None;
    }
    Some((RowResult::from_bytes(own)?, end))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use saute_formats::Value;
    use saute_sweep::Status;

    fn result(row: u64) -> RowResult {
        let numbers = vec![Some(Value::Float(0.1 + row as f64)), None, Some(Value::Text("肉".into()))];
        RowResult { row, status: Status::Done, message: None, varied: vec![Value::Integer(3)], numbers }
    }

    #[test]
    fn a_journal_that_is_cut_anywhere_keeps_every_whole_record_and_goes_on_behind_them() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("journal");
        let (mut journal, _) = Journal::open(&path).unwrap();
        (0..3).for_each(|row| journal.add(&result(row)).unwrap());
        let whole = std::fs::read(&path).unwrap();
        let length = whole.len() / 3;
        for cut in 0..=whole.len() {
            std::fs::write(&path, &whole[..cut]).unwrap();
            let (mut journal, found) = Journal::open(&path).unwrap();
            assert_eq!(found.len(), cut / length, "cut at {cut}");
            assert!(found.iter().all(|(row, found)| *found == result(*row)));
            journal.add(&result(7)).unwrap();
            assert!(Journal::open(&path).unwrap().1.contains_key(&7));
        }
    }

    #[test]
    fn a_record_with_a_wrong_byte_and_what_follows_it_is_cut_off() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("journal");
        let (mut journal, _) = Journal::open(&path).unwrap();
        (0..3).for_each(|row| journal.add(&result(row)).unwrap());
        let mut bytes = std::fs::read(&path).unwrap();
        let middle = bytes.len() / 2;
        bytes[middle] ^= 1;
        std::fs::write(&path, bytes).unwrap();
        let (_, found) = Journal::open(&path).unwrap();
        assert_eq!(found.keys().copied().collect::<Vec<_>>(), [0]);
    }
}

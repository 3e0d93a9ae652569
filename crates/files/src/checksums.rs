//! Checksums of files in a folder: a file next to them that readers of Parquet folders ignore.

use std::collections::BTreeMap;
use std::hash::Hasher;
use std::path::Path;

use siphasher::sip::SipHasher13;

use crate::regular_file;

/// Name of the file; readers of a folder of Parquet files pass over names that begin so.
pub const FILE: &str = "_checksums";

/// Larger files are not read [MiB] (chosen: a line of each part of the longest sweep).
const LARGEST_MIB: u64 = 512;

/// Checksums of files by their names.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Checksums(BTreeMap<String, u64>);

impl Checksums {
    /// Reads the checksums in a folder; none where there is no file, as in folders of before.
    pub fn in_folder(folder: &Path) -> Self {
        let text = regular_file::read_text(&folder.join(FILE), LARGEST_MIB);
        text.map_or_else(|_| Self::default(), |text| Self::parse(&text))
    }

    /// Lines that are none are passed over: a file that is not named here is not compared.
    fn parse(text: &str) -> Self {
        let line = |line: &str| {
            let (sum, name) = line.split_once("  ")?;
            Some((name.to_owned(), u64::from_str_radix(sum, 16).ok()?))
        };
        Self(text.lines().filter_map(line).collect())
    }

    /// Returns the text of the file: a line for each, the checksum (SipHash-1-3, hexadecimal) and the name.
    pub fn text(&self) -> String {
        self.0.iter().map(|(name, sum)| format!("{sum:016x}  {name}\n")).collect()
    }

    /// Notes a file.
    pub fn note(&mut self, name: &str, bytes: &[u8]) {
        self.0.insert(name.to_owned(), sum_of(bytes));
    }

    /// Returns false for a file that was noted with other bytes.
    pub fn holds(&self, name: &str, bytes: &[u8]) -> bool {
        self.0.get(name).is_none_or(|sum| *sum == sum_of(bytes))
    }
}

/// Checksum of bytes (SipHash-1-3).
pub fn sum_of(bytes: &[u8]) -> u64 {
    let mut hasher = SipHasher13::new();
    hasher.write(bytes);
    hasher.finish()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_that_was_changed_no_longer_has_its_checksum() {
        let mut sums = Checksums::default();
        sums.note("part-00000.parquet", b"rows");
        let read = Checksums::parse(&sums.text());
        assert_eq!(read, sums);
        assert!(read.holds("part-00000.parquet", b"rows") && !read.holds("part-00000.parquet", b"rowt"));
        assert!(read.holds("part-00001.parquet", b"anything"), "a folder of before has none");
    }
}

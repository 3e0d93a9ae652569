//! Bytes of a keyframe, as they are or packed: packed they take little more than half the room.

use std::borrow::Cow;
use std::io::{Read, Write};

use flate2::Compression;
use flate2::read::DeflateDecoder;
use flate2::write::DeflateEncoder;

/// Size of a part that is packed at once [bytes] (chosen: it takes a thousandth of a second or two).
const PART: usize = 128 << 10;

/// Bytes that were packed in parts, up to a place.
#[derive(Clone, Debug, Default)]
pub(super) struct Packed {
    parts: Vec<Vec<u8>>,
    /// Length of what they hold.
    length: usize,
}

impl Packed {
    /// Packs the next part of some bytes; returns true when all of them are packed.
    pub(super) fn pack_on(&mut self, bytes: &[u8]) -> bool {
        let rest = &bytes[self.length..];
        let part = &rest[..rest.len().min(PART)];
        self.parts.push(packed(part));
        self.length += part.len();
        self.length == bytes.len()
    }

    /// Size [bytes].
    pub(super) fn size(&self) -> usize {
        self.parts.iter().map(Vec::len).sum()
    }

    fn unpacked(&self) -> Vec<u8> {
        let mut bytes = Vec::with_capacity(self.length);
        for part in &self.parts {
            DeflateDecoder::new(&part[..]).read_to_end(&mut bytes).expect("this program packed it");
        }
        bytes
    }
}

fn packed(part: &[u8]) -> Vec<u8> {
    let mut encoder = DeflateEncoder::new(Vec::with_capacity(part.len()), Compression::fast());
    encoder.write_all(part).expect("memory takes all");
    let mut packed = encoder.finish().expect("memory takes all");
    packed.shrink_to_fit();
    packed
}

/// Bytes, packed or not.
#[derive(Clone, Debug)]
pub(super) enum Stored {
    /// As they are.
    Plain(Vec<u8>),
    /// Packed.
    Packed(Packed),
}

impl Stored {
    /// Size in memory [bytes].
    pub(super) fn size(&self) -> usize {
        match self {
            Self::Plain(bytes) => bytes.len(),
            Self::Packed(packed) => packed.size(),
        }
    }

    /// The bytes.
    pub(super) fn bytes(&self) -> Cow<'_, [u8]> {
        match self {
            Self::Plain(bytes) => Cow::Borrowed(bytes),
            Self::Packed(packed) => Cow::Owned(packed.unpacked()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_packed_part_by_part_comes_back() {
        let bytes: Vec<u8> = (0..3 * PART as u32 + 7).map(|k| (k / 5 % 251) as u8).collect();
        let mut packed = Packed::default();
        let parts = (1..).find(|_| packed.pack_on(&bytes)).expect("ends");
        let stored = Stored::Packed(packed);
        assert_eq!((parts, &stored.bytes()[..]), (4, &bytes[..]));
        assert!(stored.size() < bytes.len() / 2);
    }
}

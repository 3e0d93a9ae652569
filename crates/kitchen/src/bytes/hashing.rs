//! Hashes of data files: SipHash-1-3 with a key of zeros, the same on every machine.

use std::hash::Hasher;

use siphasher::sip::SipHasher13;

/// Returns the hash of parts of bytes, each with its length.
pub(crate) fn hash_of<'a>(parts: impl IntoIterator<Item = &'a [u8]>) -> u64 {
    let mut hasher = SipHasher13::new();
    for part in parts {
        hasher.write(&(part.len() as u64).to_le_bytes());
        hasher.write(part);
    }
    hasher.finish()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Files with hashes are read on other machines and by later versions.
    #[test]
    fn hashes_stay_what_they_are() {
        assert_eq!(hash_of([&b"pan"[..], b"food"]), hash_of([&b"pan"[..], b"food"]));
        assert_ne!(hash_of([&b"pan"[..], b"food"]), hash_of([&b"panf"[..], b"ood"]));
        assert_eq!(hash_of([]), 0xd1fb_a762_150c_532c);
    }
}

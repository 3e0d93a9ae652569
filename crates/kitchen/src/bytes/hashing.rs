//! Hashes of data files and states: SipHash-1-3 with a key of zeros, the same on every machine.

use std::hash::Hasher;

use postcard::ser_flavors::Flavor;
use serde::Serialize;
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

/// Returns the hash of the bytes as which a value would be stored, without storing them.
pub(super) fn hash_of_value(value: &impl Serialize) -> u64 {
    postcard::serialize_with_flavor(value, Hashed(SipHasher13::new())).expect("a state has no kind that postcard lacks")
}

/// Hashes what postcard writes.
struct Hashed(SipHasher13);

impl Flavor for Hashed {
    type Output = u64;

    fn try_extend(&mut self, data: &[u8]) -> postcard::Result<()> {
        self.0.write(data);
        Ok(())
    }

    fn try_push(&mut self, data: u8) -> postcard::Result<()> {
        self.0.write(&[data]);
        Ok(())
    }

    fn finalize(self) -> postcard::Result<u64> {
        Ok(self.0.finish())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_hash_of_a_value_is_that_of_its_bytes() {
        let value = (7u32, vec![1.5f64, f64::NAN, -0.0], "shrimp");
        let mut hasher = SipHasher13::new();
        hasher.write(&postcard::to_allocvec(&value).expect("writes"));
        assert_eq!(hash_of_value(&value), hasher.finish());
    }

    /// Files with hashes are read on other machines and by later versions.
    #[test]
    fn hashes_stay_what_they_are() {
        assert_eq!(hash_of([&b"pan"[..], b"food"]), hash_of([&b"pan"[..], b"food"]));
        assert_ne!(hash_of([&b"pan"[..], b"food"]), hash_of([&b"panf"[..], b"ood"]));
        assert_eq!(hash_of([]), 0xd1fb_a762_150c_532c);
    }
}

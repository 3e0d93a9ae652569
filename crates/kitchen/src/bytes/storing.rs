//! The one way in which postcard writes a state: counted, stored or hashed. As it is one type, the code that writes a kitchen is compiled
//! once and not three times.

use core::hash::Hasher;

use postcard::ser_flavors::Flavor;
use serde::Serialize;
use siphasher::sip::SipHasher13;

/// Why a state is always stored.
const LACKS_NONE: &str = "a state has no kind that postcard lacks";

/// Returns how many bytes a value takes.
pub(super) fn length_of(value: &impl Serialize) -> usize {
    written(value, Sink::Counted(0)).expect(LACKS_NONE) as usize
}

/// Stores a value in bytes of the length that it takes.
pub(super) fn store(value: &impl Serialize, into: &mut [u8]) {
    written(value, Sink::Stored { into, at: 0 }).expect(LACKS_NONE);
}

/// Returns the hash of the bytes as which a value would be stored, without storing them.
pub(super) fn hash_of_value(value: &impl Serialize) -> u64 {
    written(value, Sink::Hashed(SipHasher13::new())).expect(LACKS_NONE)
}

fn written(value: &impl Serialize, sink: Sink<'_>) -> postcard::Result<u64> {
    postcard::serialize_with_flavor(value, sink)
}

/// What becomes of the bytes.
enum Sink<'a> {
    Counted(usize),
    Stored { into: &'a mut [u8], at: usize },
    Hashed(SipHasher13),
}

impl Flavor for Sink<'_> {
    /// The number of bytes, or their hash.
    type Output = u64;

    fn try_extend(&mut self, data: &[u8]) -> postcard::Result<()> {
        match self {
            Self::Counted(count) => *count += data.len(),
            Self::Stored { into, at } => {
                let end = *at + data.len();
                into.get_mut(*at..end).ok_or(postcard::Error::SerializeBufferFull)?.copy_from_slice(data);
                *at = end;
            }
            Self::Hashed(hasher) => hasher.write(data),
        }
        Ok(())
    }

    fn try_push(&mut self, data: u8) -> postcard::Result<()> {
        self.try_extend(&[data])
    }

    fn finalize(self) -> postcard::Result<u64> {
        Ok(match self {
            Self::Counted(count) => count as u64,
            Self::Stored { at, .. } => at as u64,
            Self::Hashed(hasher) => hasher.finish(),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn length_bytes_and_hash_are_those_of_the_stored_value() {
        let value = (7u32, vec![1.5f64, f64::NAN, -0.0], "shrimp");
        let stored = postcard::to_allocvec(&value).expect("writes");
        assert_eq!(length_of(&value), stored.len());
        let mut bytes = vec![0; stored.len()];
        store(&value, &mut bytes);
        assert_eq!(bytes, stored);
        let mut hasher = SipHasher13::new();
        hasher.write(&stored);
        assert_eq!(hash_of_value(&value), hasher.finish());
    }
}

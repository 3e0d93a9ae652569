//! The header before the state: magic number, versions, length and checksum.

use crate::bytes::bytes_error::BytesError;
use crate::bytes::hashing::hash_of;

/// The first bytes of a stored kitchen.
const MAGIC: &[u8; 8] = b"sautekit";
/// Version of the format; every change of what is stored counts it up.
const FORMAT: u16 = 6;
/// Version of the program: another one may compute something else.
const PROGRAM: &str = env!("CARGO_PKG_VERSION");
/// Room for a header [bytes].
const LONGEST: usize = 64;

/// Returns a body with its header.
pub fn sealed(body: &[u8]) -> Vec<u8> {
    let mut bytes = Vec::new();
    append_sealed(&mut bytes, body.len(), |place| place.copy_from_slice(body));
    bytes
}

/// Appends a body of a known length with its header, in memory that is taken once; `write` fills in the body.
pub(super) fn append_sealed(bytes: &mut Vec<u8>, length: usize, write: impl FnOnce(&mut [u8])) {
    bytes.reserve_exact(length + LONGEST);
    bytes.extend_from_slice(MAGIC);
    bytes.extend_from_slice(&FORMAT.to_le_bytes());
    bytes.push(PROGRAM.len() as u8);
    bytes.extend_from_slice(PROGRAM.as_bytes());
    bytes.extend_from_slice(&(length as u64).to_le_bytes());
    let checksum = bytes.len();
    let body = checksum + size_of::<u64>();
    bytes.resize(body + length, 0);
    write(&mut bytes[body..]);
    let hash = hash_of([&bytes[body..]]);
    bytes[checksum..body].copy_from_slice(&hash.to_le_bytes());
}

/// Returns the body after a valid header.
pub(super) fn opened(bytes: &[u8]) -> Result<&[u8], BytesError> {
    let mut rest = Rest(bytes);
    if rest.take(MAGIC.len()).map_err(|_| BytesError::NoKitchen)? != MAGIC {
        return Err(BytesError::NoKitchen);
    }
    let found = u16::from_le_bytes(rest.array()?);
    if found != FORMAT {
        return Err(BytesError::Format { found, known: FORMAT });
    }
    let [length] = rest.array()?;
    let program = rest.take(length.into())?;
    if program != PROGRAM.as_bytes() {
        return Err(BytesError::Program { found: String::from_utf8_lossy(program).into_owned(), this: PROGRAM });
    }
    let length = u64::from_le_bytes(rest.array()?);
    let checksum = u64::from_le_bytes(rest.array()?);
    let body = rest.0;
    match length.cmp(&(body.len() as u64)) {
        std::cmp::Ordering::Greater => Err(BytesError::Truncated { missing: length - body.len() as u64 }),
        std::cmp::Ordering::Equal if hash_of([body]) == checksum => Ok(body),
        _ => Err(BytesError::Damaged),
    }
}

/// Bytes not yet read.
struct Rest<'a>(&'a [u8]);

impl<'a> Rest<'a> {
    fn take(&mut self, count: usize) -> Result<&'a [u8], BytesError> {
        let missing = BytesError::Truncated { missing: (count - self.0.len().min(count)) as u64 };
        let (taken, rest) = self.0.split_at_checked(count).ok_or(missing)?;
        self.0 = rest;
        Ok(taken)
    }

    fn array<const N: usize>(&mut self) -> Result<[u8; N], BytesError> {
        let mut array = [0; N];
        array.copy_from_slice(self.take(N)?);
        Ok(array)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_body_comes_back_and_every_fault_has_its_reason() {
        let bytes = sealed(b"onions");
        assert_eq!(opened(&bytes), Ok(&b"onions"[..]));
        assert_eq!(opened(b"onions"), Err(BytesError::NoKitchen));
        assert_eq!(opened(&bytes[..bytes.len() - 2]), Err(BytesError::Truncated { missing: 2 }));
        assert!(matches!(opened(&bytes[..12]), Err(BytesError::Truncated { .. })));
        let changed = |at: usize| {
            let mut bytes = bytes.clone();
            bytes[at] ^= 1;
            bytes
        };
        assert_eq!(opened(&changed(bytes.len() - 1)), Err(BytesError::Damaged));
        assert_eq!(opened(&[&bytes[..], b"!"].concat()), Err(BytesError::Damaged));
        assert_eq!(opened(&changed(8)), Err(BytesError::Format { found: FORMAT ^ 1, known: FORMAT }));
        assert!(matches!(opened(&changed(11)), Err(BytesError::Program { .. })));
    }
}

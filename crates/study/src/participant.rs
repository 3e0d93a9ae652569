//! The code of a participant, which is all that is known of a person, and the condition that follows from it.

use std::fmt;
use std::str::FromStr;

use super::protocol::Protocol;
use super::random::Random;

/// A code: 1 to 12 letters, digits and hyphens.
#[derive(Clone, Debug, Eq, Ord, PartialEq, PartialOrd)]
pub struct Participant(String);

/// Longest code [letters].
pub const LONGEST_CODE: usize = 12;

/// A code that cannot be used.
#[derive(Clone, Debug, Eq, PartialEq, thiserror::Error)]
#[error("\"{0}\" is no code: use 1 to {LONGEST_CODE} letters (a–z), digits and hyphens, as P07; no names")]
pub struct NoCode(pub String);

impl FromStr for Participant {
    type Err = NoCode;

    fn from_str(text: &str) -> Result<Self, NoCode> {
        let plain = |c: char| c.is_ascii_alphanumeric() || c == '-';
        let is_code = text.len() <= LONGEST_CODE && text.chars().all(plain) && text.chars().any(|c| c != '-');
        if is_code { Ok(Self(text.to_owned())) } else { Err(NoCode(text.chars().take(40).collect())) }
    }
}

impl fmt::Display for Participant {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        self.0.fmt(f)
    }
}

impl Participant {
    /// The code.
    pub fn code(&self) -> &str {
        &self.0
    }

    /// The number at the end of the code; none where it ends with a letter.
    fn number(&self) -> Option<u64> {
        let digits = self.0.len() - self.0.trim_end_matches(|c: char| c.is_ascii_digit()).len();
        self.0[self.0.len() - digits..].parse().ok()
    }

    /// Place of the participant's condition in the protocol.
    ///
    /// Numbers at the ends of codes are taken in blocks of as many as there are conditions. Each block contains every condition
    /// once, in an order that is drawn with the protocol's seed: participants with consecutive numbers are balanced to within
    /// one, and nobody can guess the next condition. A code without a number is assigned by its checksum, which is balanced
    /// on average only.
    pub fn condition(&self, protocol: &Protocol) -> usize {
        let count = protocol.conditions.len() as u64;
        let (block, place) = match self.number() {
            Some(number) => (number.saturating_sub(1) / count, number.saturating_sub(1) % count),
            None => (u64::MAX, u64::from(crc32fast::hash(self.0.as_bytes())) % count),
        };
        let mut order: Vec<usize> = (0..protocol.conditions.len()).collect();
        Random::new(&[u64::from(protocol.seed), block]).shuffle(&mut order);
        order[place as usize]
    }
}

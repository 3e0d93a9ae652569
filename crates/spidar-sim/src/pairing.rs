//! The pairing code: drawn by the system, and one try per second.

use std::time::{Duration, Instant};

/// Time after a wrong code in which no code is looked at (chosen: six digits then last for days).
const WAIT: Duration = Duration::from_secs(1);
/// Number of codes of six digits without a leading zero.
const CODES: u32 = 900_000;
/// Smallest code of six digits.
const FIRST: u32 = 100_000;

/// The system provided no random numbers.
#[derive(Debug, thiserror::Error)]
#[error("the system provided no random numbers for a pairing code: {0}\n  remedy: give a code with --pairing")]
pub struct NoRandom(#[from] getrandom::Error);

/// Result of a try.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CodeCheck {
    /// The code is right, or none is needed.
    Paired,
    /// The code is wrong.
    Wrong,
    /// The code was not looked at, so soon after a wrong one.
    TooSoon,
}

/// A pairing code; 0 needs none.
#[derive(Clone, Debug)]
pub struct Pairing {
    code: u32,
    closed_until: Option<Instant>,
}

impl Pairing {
    /// Creates the pairing with a code.
    pub fn new(code: u32) -> Self {
        Self { code, closed_until: None }
    }

    /// Checks a code.
    pub fn check(&mut self, given: u32, now: Instant) -> CodeCheck {
        if self.code == 0 {
            return CodeCheck::Paired;
        }
        if self.wait(now) > Duration::ZERO {
            return CodeCheck::TooSoon;
        }
        if given == self.code {
            return CodeCheck::Paired;
        }
        self.closed_until = Some(now + WAIT);
        CodeCheck::Wrong
    }

    /// Returns the time until a code is looked at again.
    pub fn wait(&self, now: Instant) -> Duration {
        self.closed_until.map_or(Duration::ZERO, |until| until.saturating_duration_since(now))
    }
}

/// Draws a code of six digits, all equally likely.
pub fn draw() -> Result<u32, NoRandom> {
    // Numbers beyond the largest multiple of the codes would make some codes more likely.
    let most = u32::MAX - u32::MAX % CODES;
    loop {
        let number = getrandom::u32()?;
        if number < most {
            return Ok(FIRST + number % CODES);
        }
    }
}
